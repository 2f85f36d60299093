#include "verify/oracle/broken_scene.hpp"

#include "verify/oracle/temporary_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace halfway::verify {

int line_at(const std::string& text, std::size_t position) {
  return 1 + int(std::count(text.begin(), text.begin() + std::ptrdiff_t(position), '\n'));
}

Finding refused(const std::string& what, const std::filesystem::path& file, const std::string& place) {
  const std::string message = refusal(file);
  const int missing = !message.starts_with(file.filename().string() + ":" + place) +
                      (message.find("; allowed: ") == std::string::npos);
  return finding("scenes/refuses/" + what)
      .about("scenes")
      .measured(missing, message.empty() ? "it was accepted" : message)
      .in("missing parts")
      .at_most(0,
               fmt::format("the message must begin with the file's name and \"{}\", and say what is allowed",
                           place))
      .by(Oracle::closed_form);
}

Finding broken_refused(std::string good, const Broken& broken) {
  const auto at = good.find(broken.from);
  if (at == std::string::npos) throw std::logic_error(fmt::format("{}: nothing to break", broken.what));
  const std::string text = good.replace(at, std::string(broken.from).size(), broken.to);
  const TemporaryScene scene(broken.what, text);
  return refused(broken.what, scene.path(),
                 fmt::format("{}: {}", line_at(text, text.find("#!")), broken.key));
}

Finding accepted(const std::string& what, const std::string& good) {
  const TemporaryScene scene(what, good);
  const std::string message = refusal(scene.path());
  return finding("scenes/accepts/" + what)
      .about("scenes")
      .measured(!message.empty(), message)
      .at_most(0, "the text that the other checks break in one place")
      .by(Oracle::closed_form);
}

}  // namespace halfway::verify
