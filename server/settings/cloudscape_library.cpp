// The named documents of a server: presets, a folder's files, and what was put.
#include <algorithm>
#include <map>
#include <mutex>

#include "core/error.h"
#include "core/log.h"
#include "settings/cloudscape_json.h"
#include "settings/cloudscape_reader.h"
#include "settings/json_text.h"
#include "settings/named_documents.h"
#include "settings/text_file.h"

namespace cloudscape {
extern const EmbeddedFiles embedded_presets;
}

namespace cloudscape::settings {
namespace {

namespace fs = std::filesystem;

// tuned: more than anyone keeps by hand, and 64 MiB at the most. A document with every key is about 5 KiB.
constexpr std::size_t max_documents = 256;
constexpr std::size_t max_document_bytes = 256 * 1024;

struct Document {
  std::string text;
  std::shared_ptr<const Cloudscape> cloudscape;
  bool preset = false;
};

bool is_name(std::string_view name) {
  const auto lower = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto follows = [&](char c) { return lower(c) || (c >= '0' && c <= '9') || c == '-'; };
  return !name.empty() && name.size() <= 64 && lower(name[0]) && std::all_of(name.begin(), name.end(), follows);
}

void check_name(const std::string& name) {
  if (!is_name(name)) refuse("/name", name, "1 to 64 of a-z, 0-9 and -, the first a letter");
}

Document make_document(std::string text, const std::string& source, bool preset) {
  auto cloudscape = std::make_shared<const Cloudscape>(parse_cloudscape(text, source));
  return {std::move(text), std::move(cloudscape), preset};
}

std::vector<fs::path> json_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().extension() == ".json") files.push_back(entry->path());
  if (error && error != std::errc::no_such_file_or_directory)
    log::warn("cannot list cloudscapes in {}: {}", folder.string(), error.message());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

struct CloudscapeLibrary::State {
  fs::path folder;
  mutable std::mutex mutex;
  std::map<std::string, Document, std::less<>> documents;

  std::size_t stored() const {
    return std::count_if(documents.begin(), documents.end(), [](const auto& entry) { return !entry.second.preset; });
  }
  void check_replaceable(const std::string& name) const {
    if (const auto found = documents.find(name); found != documents.end() && found->second.preset)
      throw InvalidInput("/name", "is " + shown(name) + ": a preset, which cannot be changed; choose another name");
  }
  void check_room(const std::string& name) const {
    if (!documents.contains(name) && stored() >= max_documents)
      throw OverLimit("", "there are " + std::to_string(max_documents) +
                              " documents already, the most that are kept: delete one first");
  }
  const Document& document(std::string_view name) const {
    if (const auto found = documents.find(name); found != documents.end()) return found->second;
    std::vector<std::string_view> names;
    for (const auto& entry : documents) names.push_back(entry.first);
    throw NotFound("there is no cloudscape " + shown(name) + ": " + suggestion(name, names));
  }
  void add_presets() {
    for (const EmbeddedFile& file : embedded_presets)
      documents[document_name(file)] = make_document(std::string(file.bytes), std::string(file.path), true);
  }
  void add_file(const fs::path& file) {
    const std::string name = file.stem().string();
    check_name(name);
    check_replaceable(name);
    check_room(name);
    documents[name] = make_document(read_text_file(file, max_document_bytes), file.string(), false);
  }
  void store(const std::string& name, std::string_view text) const {
    if (folder.empty()) return;
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw Error("cannot make the folder " + folder.string() + ": " + error.message());
    write_text_file(folder / (name + ".json"), text);
  }
};

CloudscapeLibrary::CloudscapeLibrary(fs::path folder) : state_(std::make_unique<State>()) {
  state_->folder = std::move(folder);
  state_->add_presets();
  if (state_->folder.empty()) return;
  for (const fs::path& file : json_files(state_->folder)) {
    try {
      state_->add_file(file);
    } catch (const Error& error) {
      log::warn("{} is left out: {}", file.string(), error.what());
    }
  }
}

CloudscapeLibrary::~CloudscapeLibrary() = default;

std::vector<CloudscapeLibrary::Entry> CloudscapeLibrary::list() const {
  const std::lock_guard lock(state_->mutex);
  std::vector<Entry> entries;
  for (const auto& [name, document] : state_->documents)
    entries.push_back({name, document.cloudscape->title, document.cloudscape->description, document.preset});
  return entries;
}

std::shared_ptr<const Cloudscape> CloudscapeLibrary::get(std::string_view name) const {
  const std::lock_guard lock(state_->mutex);
  return state_->document(name).cloudscape;
}

std::string CloudscapeLibrary::text(std::string_view name) const {
  const std::lock_guard lock(state_->mutex);
  return state_->document(name).text;
}

bool CloudscapeLibrary::put(const std::string& name, std::string_view text) {
  check_name(name);
  if (text.size() > max_document_bytes)
    throw OverLimit("", "the document has " + std::to_string(text.size()) + " bytes: must have at most " +
                            std::to_string(max_document_bytes));
  Document document = make_document(std::string(text), "body", false);
  const std::lock_guard lock(state_->mutex);
  state_->check_replaceable(name);
  state_->check_room(name);
  state_->store(name, text);
  return state_->documents.insert_or_assign(name, std::move(document)).second;
}

bool CloudscapeLibrary::remove(const std::string& name) {
  const std::lock_guard lock(state_->mutex);
  state_->document(name);
  state_->check_replaceable(name);
  std::error_code error;
  if (!state_->folder.empty()) fs::remove(state_->folder / (name + ".json"), error);
  if (error) throw Error("cannot delete " + name + ".json: " + error.message());
  return state_->documents.erase(name) > 0;
}

std::shared_ptr<const Cloudscape> find_cloudscape(const CloudscapeLibrary& library, const std::string& name_or_path) {
  if (!is_file_path(name_or_path)) return library.get(name_or_path);
  const std::string text = read_text_file(name_or_path, max_document_bytes);
  return std::make_shared<const Cloudscape>(read_cloudscape(parse_json(text, name_or_path), name_or_path + "#"));
}

}  // namespace cloudscape::settings
