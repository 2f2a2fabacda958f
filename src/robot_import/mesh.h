#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace hexapod {

/// Corners of a mesh and its triangles, in metres.
struct Mesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<unsigned, 3>> triangles;
};

/// Finds mesh files by the names that URDFs give them.
class MeshFiles {
 public:
  /// `urdf_folder`: where relative names start, and from where packages are looked for upwards;
  /// `mesh_path`: a folder to look in first, or "".
  MeshFiles(std::string urdf_folder, std::string mesh_path);

  /// The path of an existing file for "package://name/a/b.stl", "file:///a/b.stl", "a/b.stl" or
  /// "/a/b.stl"; "" when there is none. A package is the folder of its name, or one that has a
  /// package.xml with it.
  std::string find(const std::string& name) const;

 private:
  std::string urdf_folder_;
  std::string mesh_path_;
};

/// Reads an STL, DAE or OBJ file, whatever assimp knows; a DAE's own unit and up axis are taken as
/// rviz takes them. Throws std::runtime_error naming the file and what is wrong with it.
Mesh readMesh(const std::string& file, const Eigen::Vector3d& scale);

}  // namespace hexapod
