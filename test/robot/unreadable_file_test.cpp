#include <gtest/gtest.h>

#include "shipped_files.h"

namespace hexapod {
namespace {

TEST(UnreadableFile, TextThatIsNoUrdfIsRefused) {
  const std::string yaml = contentOf(kYamlFile);
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a x='/>'>";
  const std::vector<std::string> texts = {"",
                                          " \n",
                                          std::string("\0\1\2ELF", 6),
                                          "robot",
                                          "<robot",
                                          "<robot/>",
                                          "<model/>",
                                          "<robot name='r'></robot>",
                                          "<robot name='r'><link/></robot>",
                                          deep,
                                          "<!-- " + deep,
                                          contentOf(kUrdfFile).substr(0, 5000),
                                          yaml};
  for (const std::string& text : texts) {
    EXPECT_EQ(complaint(text, yaml).find("r.urdf: "), 0u) << text.substr(0, 100);
  }
}

TEST(UnreadableFile, TextThatIsNoYamlIsRefused) {
  const std::string urdf = contentOf(kUrdfFile);
  const std::vector<std::string> texts = {"",
                                          "# nothing\n",
                                          std::string("a: \0", 4),
                                          "3",
                                          "- a\n- b",
                                          "a: [",
                                          "a: b: c",
                                          "{",
                                          std::string(100000, '['),
                                          std::string(100000, '{'),
                                          "&a [*a]",
                                          urdf};
  for (const std::string& text : texts) {
    EXPECT_EQ(complaint(urdf, text).find("r.yaml: "), 0u) << text.substr(0, 100);
  }
}

TEST(UnreadableFile, EveryTruncationIsRefusedWithASentence) {
  const std::string urdf = contentOf(kUrdfFile);
  const std::string yaml = contentOf(kYamlFile);
  // Behind these the files hold only layout.
  const std::size_t urdf_end = urdf.rfind("</robot>") + 8;
  const std::size_t yaml_end = yaml.rfind("0.5");
  for (std::size_t size = 0; size < urdf_end; size += 97) {
    EXPECT_NE(complaint(urdf.substr(0, size), yaml), "") << size;
  }
  for (std::size_t size = 0; size < yaml_end; size += 41) {
    EXPECT_NE(complaint(urdf, yaml.substr(0, size)), "") << size;
  }
}

TEST(UnreadableFile, FileThatCannotBeReadIsNamed) {
  const auto said = [](const std::string& urdf_file, const std::string& yaml_file) {
    try {
      loadRobot(urdf_file, yaml_file);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(said("urdf/none.urdf", "config/none.yaml"),
            "urdf/none.urdf: there is no such file; check the path.\n"
            "config/none.yaml: there is no such file; check the path.");
  EXPECT_NE(said("urdf", kYamlFile).find("urdf: expected a file"), std::string::npos);
  EXPECT_NE(said("/dev/zero", kYamlFile).find("/dev/zero: expected a file"), std::string::npos);
  EXPECT_NE(said(kUrdfFile, std::string(5000, 'a')), "");
}

}  // namespace
}  // namespace hexapod
