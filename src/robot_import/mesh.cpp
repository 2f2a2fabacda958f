#include "robot_import/mesh.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace hexapod {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPackage = "package://";
constexpr const char* kFile = "file://";
// Folders above the URDF in which its package is looked for, and how deep below them.
constexpr int kMostLevelsUp = 4;

bool isFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

// Whether a folder is the package `name`, by its own name or by its package.xml.
bool isPackage(const fs::path& folder, const std::string& name) {
  if (folder.filename() == name) return true;
  std::ifstream stream(folder / "package.xml");
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return text.find("<name>" + name + "</name>") != std::string::npos;
}

void addNode(const aiScene& scene, const aiNode& node, const aiMatrix4x4& root_from_parent,
             const Eigen::Vector3d& scale, Mesh& mesh) {
  const aiMatrix4x4 root_from_node = root_from_parent * node.mTransformation;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& part = *scene.mMeshes[node.mMeshes[m]];
    const auto first = static_cast<unsigned>(mesh.vertices.size());
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const aiVector3D point = root_from_node * part.mVertices[v];
      mesh.vertices.push_back(Eigen::Vector3d(point.x, point.y, point.z).cwiseProduct(scale));
    }
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      if (face.mNumIndices != 3) continue;
      mesh.triangles.push_back(
          {first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
    }
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c) {
    addNode(scene, *node.mChildren[c], root_from_node, scale, mesh);
  }
}

// The scale in a root's rotation-and-scale, without the rotation to another up axis.
aiMatrix4x4 unitOnly(const aiMatrix4x4& root) {
  aiVector3D scale, position;
  aiQuaternion rotation;
  root.Decompose(scale, rotation, position);
  aiMatrix4x4 result;
  aiMatrix4x4::Scaling(scale, result);
  return result;
}

}  // namespace

MeshFiles::MeshFiles(std::string urdf_folder, std::string mesh_path)
    : urdf_folder_(std::move(urdf_folder)), mesh_path_(std::move(mesh_path)) {}

std::string MeshFiles::find(const std::string& name) const {
  std::string relative = name;
  std::string package;
  if (name.rfind(kPackage, 0) == 0) {
    relative = name.substr(std::string(kPackage).size());
    const std::size_t slash = relative.find('/');
    package = relative.substr(0, slash);
    relative = slash == std::string::npos ? "" : relative.substr(slash + 1);
  } else if (name.rfind(kFile, 0) == 0) {
    relative = name.substr(std::string(kFile).size());
  }
  std::vector<fs::path> candidates;
  if (!mesh_path_.empty()) {
    const fs::path folder = mesh_path_;
    candidates = {folder / package / relative, folder / relative,
                  folder / fs::path(relative).filename()};
  }
  if (package.empty()) candidates.push_back(fs::path(urdf_folder_) / relative);
  fs::path above = fs::absolute(urdf_folder_).lexically_normal();
  if (above.filename().empty()) above = above.parent_path();
  for (int level = 0; level < kMostLevelsUp && !package.empty(); ++level) {
    if (isPackage(above, package)) candidates.push_back(above / relative);
    candidates.push_back(above / package / relative);
    above = above.parent_path();
  }
  for (const fs::path& candidate : candidates) {
    if (isFile(candidate)) return candidate.lexically_normal().string();
  }
  return "";
}

Mesh readMesh(const std::string& file, const Eigen::Vector3d& scale) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(
      file, aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_SortByPType);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw std::runtime_error(file + " cannot be read as a mesh: " + importer.GetErrorString());
  }
  Mesh mesh;
  // assimp turns a DAE's up axis; rviz and URDF do not.
  aiNode& root = *scene->mRootNode;
  root.mTransformation = unitOnly(root.mTransformation);
  addNode(*scene, root, aiMatrix4x4(), scale, mesh);
  if (mesh.vertices.empty()) throw std::runtime_error(file + " has no vertices.");
  return mesh;
}

}  // namespace hexapod
