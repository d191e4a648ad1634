#include "window/open_editor.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <lumen/error.h>

extern char** environ;

namespace lumenshop {

void open_in_editor(const std::string& file, int line) {
  if (!std::filesystem::exists(file)) throw lumen::Error(file, "no such file");
  const char* editor = std::getenv("VISUAL");
  if (!editor || !*editor) editor = std::getenv("EDITOR");
  if (!editor || !*editor) throw lumen::Error(file + ":" + std::to_string(line), "no editor is known", "set VISUAL, such as VISUAL=kate");

  // The shell splits what the variable holds ("code --goto") and leaves at once: no child stays to be waited for. The
  // file is an argument, not a part of the script. posix_spawn, for a fork after GL is up is unsafe.
  std::vector<std::string> words = {"/bin/sh", "-c", "exec </dev/null >/dev/null 2>&1; setsid $0 \"$@\" &", editor, "+" + std::to_string(line), file};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (const int error = posix_spawn(&child, "/bin/sh", nullptr, nullptr, arguments.data(), environ); error != 0)
    throw lumen::Error(file, std::string("the editor does not start: ") + std::strerror(error));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
}

}  // namespace lumenshop
