/// Conversion of numbers and names.
#include "arrays.h"

#include <algorithm>
#include <set>

#include <vtkArrayDispatch.h>
#include <vtkDataArrayRange.h>
#include <vtkFloatArray.h>

lumen::Array<float> floats_of(vtkDataArray* array) {
  const auto count = static_cast<std::size_t>(array->GetNumberOfValues());
  if (auto* plain = vtkFloatArray::SafeDownCast(array)) {
    const vtkSmartPointer<vtkFloatArray> owner = plain;
    return {std::span<const float>(plain->GetPointer(0), count), std::make_shared<vtkSmartPointer<vtkFloatArray>>(owner)};
  }
  std::vector<float> values(count);
  const auto copy = [&](auto* typed) {
    const auto range = vtk::DataArrayValueRange(typed);
    std::transform(range.begin(), range.end(), values.begin(), [](auto value) { return static_cast<float>(value); });
  };
  if (!vtkArrayDispatch::Dispatch::Execute(array, copy)) copy(array);
  return values;
}

lumen::Array<float> gathered(const lumen::Array<float>& values, int components, std::span<const std::uint32_t> tuples) {
  const auto width = static_cast<std::size_t>(components);
  std::vector<float> result(tuples.size() * width);
  float* target = result.data();
  for (const std::uint32_t tuple : tuples) target = std::copy_n(values.data() + tuple * width, width, target);
  return result;
}

lumen::Array<float> part_of(const lumen::Array<float>& values, std::size_t begin, std::size_t count) {
  return {values.view().subspan(begin, count), std::make_shared<lumen::Array<float>>(values)};
}

std::vector<lumen::Attribute> attributes_of(vtkDataSetAttributes* data, lumen::Attribute::On on, vtkIdType tuples,
                                            const std::vector<vtkDataArray*>& except, lumen::WorkerReply& reply) {
  std::vector<lumen::Attribute> result;
  std::set<std::string> names;
  for (int index = 0; index < data->GetNumberOfArrays(); ++index) {
    vtkAbstractArray* any = data->GetAbstractArray(index);
    vtkDataArray* array = data->GetArray(index);
    if (!any || (array && std::find(except.begin(), except.end(), array) != except.end())) continue;
    std::string name = any->GetName() && *any->GetName() ? any->GetName() : "array " + std::to_string(index + 1);
    const auto skip = [&](const std::string& why) {
      reply.notes.push_back({lumen::Severity::note, "array '" + name + "' left out: " + why});
    };
    const int components = any->GetNumberOfComponents();
    if (!array) {
      skip("it holds no numbers");
    } else if (components < 1 || components > 16) {
      skip(std::to_string(components) + " components; 1 to 16 are possible");
    } else if (array->GetNumberOfTuples() != tuples) {
      skip(lumen::grouped(static_cast<std::size_t>(array->GetNumberOfTuples())) + " tuples for " + lumen::grouped(static_cast<std::size_t>(tuples)));
    } else {
      const std::string stem = name;
      for (int again = 2; !names.insert(name).second; ++again) name = stem + " " + std::to_string(again);
      result.push_back({name, on, components, floats_of(array)});
    }
  }
  return result;
}
