/// Where the program's parts lie: relative to the executable, in a build tree as in an installation.
///   bin/lumenshop  lib/lumenshop/plugins/*.so  lib/lumenshop/workers/*.so  lib/lumenshop/lumenshop-helper
///   share/lumenshop/shaders  share/lumenshop/sessions  share/lumenshop/templates  share/lumenshop/build.json (build trees only)
#pragma once

#include <filesystem>

namespace lumenshop {

struct Installation {
  std::filesystem::path root;
  static Installation find();  ///< from /proc/self/exe
  std::filesystem::path plugins() const { return root / "lib/lumenshop/plugins"; }
  std::filesystem::path workers() const { return root / "lib/lumenshop/workers"; }
  std::filesystem::path helper() const { return root / "lib/lumenshop/lumenshop-helper"; }
  std::filesystem::path shaders() const { return root / "share/lumenshop/shaders"; }
  std::filesystem::path sessions() const { return root / "share/lumenshop/sessions"; }
  std::filesystem::path templates() const { return root / "share/lumenshop/templates"; }  ///< of `lumenshop new`
  std::filesystem::path build_description() const { return root / "share/lumenshop/build.json"; }
  static std::filesystem::path user_plugins();  ///< $XDG_DATA_HOME/lumenshop/plugins
  static std::filesystem::path user_gallery();  ///< $XDG_DATA_HOME/lumenshop/gallery: pictures of spheres
  static std::filesystem::path user_config();   ///< $XDG_CONFIG_HOME/lumenshop
};

}  // namespace lumenshop
