#include "commands/gnuplot.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>

#include "base/signals.hpp"
#include "core/errors.hpp"

namespace ehl::program {
namespace {

namespace files = std::filesystem;

constexpr auto wake_interval = std::chrono::milliseconds(5);
constexpr int not_started = 127;  // the status by which a shell reports that the program was not found

[[noreturn]] void be_gnuplot(const std::string& settings, const std::string& script, pid_t parent) {
  ::signal(SIGPIPE, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(not_started);
  ::setenv("LC_ALL", "C.UTF-8", 1);  // the scripts are in UTF-8 and need decimal points, whatever the locale is
  ::execlp("gnuplot", "gnuplot", "-e", settings.c_str(), script.c_str(), static_cast<char*>(nullptr));
  ::_exit(not_started);
}

}  // namespace

std::string gnuplot_literal(const std::string& text) {
  std::string literal = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const bool plain = code >= 0x80 || std::isalnum(code) != 0 || std::strchr(" ./_-", c) != nullptr;
    literal += plain && c != '\0' ? std::string(1, c) : fmt::format("\\{:03o}", code);
  }
  return literal + "\"";
}

std::string no_pipe(const std::string& path) { return files::path(path).is_absolute() ? path : "./" + path; }

PlainNames::~PlainNames() {
  std::error_code error;
  if (!folder_.empty()) files::remove_all(folder_, error);  // removes the links but not the files they point to
}

std::string PlainNames::of(const std::string& path, const std::string& link) {
  if (path.find('\'') == std::string::npos) return no_pipe(path);
  std::error_code error;
  if (folder_.empty()) {
    std::string name = files::temp_directory_path(error).string();
    if (error || name.find('\'') != std::string::npos) name = "/tmp";
    name += "/ehl_plot_XXXXXX";
    if (::mkdtemp(name.data()) == nullptr)
      throw core::FileError(name + ": a folder for links cannot be made: " + std::strerror(errno));
    folder_ = name;
  }
  const std::string plain = folder_ + "/" + link;
  files::create_symlink(files::absolute(path), plain, error);
  if (error) throw core::FileError(plain + ": a link cannot be made: " + error.message());
  return plain;
}

void run_gnuplot(const std::string& settings, const std::string& script, const std::string& figure) {
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) throw core::FileError(std::string("gnuplot cannot be started: ") + std::strerror(errno));
  if (child == 0) be_gnuplot(settings, script, parent);
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (stop_requested()) ::kill(child, SIGKILL);
    std::this_thread::sleep_for(wake_interval);
  }
  if (stop_requested()) throw core::Interrupted();
  if (WIFEXITED(status) && WEXITSTATUS(status) == not_started)
    throw core::FileError("gnuplot cannot be started: install it (Debian: gnuplot-nox)");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw core::FileError("gnuplot failed on figure " + figure + "; its message is above");
}

}  // namespace ehl::program
