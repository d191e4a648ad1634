/// VTK's arrays as ours: without a copy where type and layout agree.
#pragma once

#include <memory>
#include <vector>

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkSmartPointer.h>

#include <lumen/data.h>
#include <lumen/worker.h>

/// All values of a numeric array as float; shares its memory if it is a plain array of floats.
lumen::Array<float> floats_of(vtkDataArray* array);

/// The same memory as tuples of T (of floats only).
template <class T> lumen::Array<T> tuples_of(const lumen::Array<float>& floats) {
  const auto owner = std::make_shared<lumen::Array<float>>(floats);
  return {std::span(reinterpret_cast<const T*>(floats.data()), floats.size() * sizeof(float) / sizeof(T)), owner};
}

/// The tuples with the given numbers, in that order.
lumen::Array<float> gathered(const lumen::Array<float>& values, int components, std::span<const std::uint32_t> tuples);

/// A part of an array, sharing its memory.
lumen::Array<float> part_of(const lumen::Array<float>& values, std::size_t begin, std::size_t count);

/// The numeric arrays of points or cells, but `except`; what cannot be kept becomes a note. Names become unique.
std::vector<lumen::Attribute> attributes_of(vtkDataSetAttributes* data, lumen::Attribute::On on, vtkIdType tuples,
                                            const std::vector<vtkDataArray*>& except, lumen::WorkerReply& reply);
