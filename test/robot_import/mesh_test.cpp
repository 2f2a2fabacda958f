#include "robot_import/mesh.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace hexapod {
namespace {

class MeshTest : public testing::Test {
 protected:
  MeshTest() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~MeshTest() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    const std::filesystem::path file = folder_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
    return file.string();
  }

  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) / "hexapod_mesh_test";
};

// Of all corners.
Eigen::Vector3d size(const Mesh& mesh) {
  Eigen::Vector3d low = mesh.vertices.front(), high = low;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  return high - low;
}

void expectSize(const Mesh& mesh, double x_m, double y_m, double z_m) {
  EXPECT_LT((size(mesh) - Eigen::Vector3d(x_m, y_m, z_m)).norm(), 1e-6) << size(mesh).transpose();
}

// A tetrahedron that reaches 1, 2 and 3 along its axes.
constexpr const char* kObj = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 2 3\nf 1 2 4\nf 1 3 4\n";

std::string dae(const std::string& up_axis, const std::string& unit_m) {
  return "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' "
         "version='1.4.1'><asset><unit meter='" +
         unit_m + "'/><up_axis>" + up_axis +
         "</up_axis></asset><library_geometries><geometry id='g'><mesh><source id='p'><float_array "
         "id='a' count='12'>0 0 0 1 0 0 0 2 0 0 0 3</float_array><technique_common><accessor "
         "source='#a' count='4' stride='3'><param name='X' type='float'/><param name='Y' "
         "type='float'/><param name='Z' type='float'/></accessor></technique_common></source>"
         "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices><triangles count='3'>"
         "<input semantic='VERTEX' source='#v' offset='0'/><p>0 1 2 0 1 3 0 2 3</p></triangles>"
         "</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id='s'><node>"
         "<instance_geometry url='#g'/></node></visual_scene></library_visual_scenes><scene>"
         "<instance_visual_scene url='#s'/></scene></COLLADA>";
}

TEST_F(MeshTest, AnObjIsReadInTheScaleOfTheUrdf) {
  const Mesh mesh = readMesh(write("a.obj", kObj), {0.1, 0.1, 0.01});
  expectSize(mesh, 0.1, 0.2, 0.03);
  EXPECT_EQ(mesh.triangles.size(), 3u);
}

TEST_F(MeshTest, ADaeKeepsItsUnitAndIsNotTurnedToAnotherUpAxis) {
  const Eigen::Vector3d one(1, 1, 1);
  expectSize(readMesh(write("metres.dae", dae("Z_UP", "1")), one), 1, 2, 3);
  expectSize(readMesh(write("y_up.dae", dae("Y_UP", "1")), one), 1, 2, 3);
  expectSize(readMesh(write("millimetres.dae", dae("Z_UP", "0.001")), one), 0.001, 0.002, 0.003);
}

TEST_F(MeshTest, FilesThatAreNoMeshesAreRefusedByName) {
  for (const char* name : {"broken.stl", "broken.dae", "broken.obj"}) {
    try {
      readMesh(write(name, "solid"), {1, 1, 1});
      ADD_FAILURE() << name;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }
}

TEST_F(MeshTest, MeshesAreFoundByPackageAndByPath) {
  const std::string file = write("my_robot/meshes/leg.obj", kObj);
  write("my_robot/package.xml", "<package><name>legs_description</name></package>");
  write("my_robot/urdf/my.urdf", "<robot/>");
  const MeshFiles beside(folder_.string() + "/my_robot/urdf", "");
  for (const std::string& name :
       {std::string("package://my_robot/meshes/leg.obj"), "file://" + file, file,
        std::string("package://legs_description/meshes/leg.obj"),
        std::string("../meshes/leg.obj")}) {
    EXPECT_EQ(beside.find(name), file) << name;
  }
  EXPECT_EQ(beside.find("package://other/meshes/leg.obj"), "");
  const MeshFiles elsewhere("/", folder_.string() + "/my_robot/meshes");
  EXPECT_EQ(elsewhere.find("package://other/deep/leg.obj"), file);
}

}  // namespace
}  // namespace hexapod
