/// Connectivity of triangles alone, by OpenMesh: positions and normals stay in the mesh's arrays.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>

struct ConnectivityTraits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::None);
  FaceAttributes(OpenMesh::Attributes::None);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
};
using Connectivity = OpenMesh::TriMesh_ArrayKernelT<ConnectivityTraits>;
