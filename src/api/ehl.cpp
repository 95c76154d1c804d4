// The C interface: it calls the same functions as the program.
#include "api/ehl.h"

#include <algorithm>
#include <exception>
#include <new>
#include <optional>

#include "api/held_result.hpp"
#include "api/keys_json.hpp"
#include "base/exit_status.hpp"
#include "base/machine.hpp"
#include "case/catalogue.hpp"
#include "core/errors.hpp"
#include "core/processor_level.hpp"
#include "tables/csv.hpp"

struct ehl_result {
  ehl::program::HeldResult held{};
};

namespace {

using namespace ehl::program;

// True if a status of the interface has the same number as that of the program.
constexpr bool same(int of_interface, int of_program) { return of_interface == of_program; }
static_assert(same(EHL_SOLVED, solved) && same(EHL_INTERNAL_FAILURE, internal_failure) &&
              same(EHL_WRONG_INPUT, wrong_input) && same(EHL_NOT_CONVERGED, not_converged) &&
              same(EHL_FILE_TROUBLE, file_trouble) && same(EHL_INTERRUPTED, interrupted));

// in: fill: the function that fills the result. out: nullptr only if there is not even memory for an empty result.
template <class Fill>
ehl_result* filled(Fill fill) noexcept {
  auto* result = new (std::nothrow) ehl_result;
  if (result == nullptr) return nullptr;
  const auto failed = [&](int status, const char* message) {
    result->held.status = status;
    try {
      result->held.messages.emplace_back(message);
    } catch (...) {  // no memory for the messages: only the status is set
    }
  };
  try {
    fill(result->held);
  } catch (const ehl::core::InputError& error) {
    failed(wrong_input, error.what());
  } catch (const std::exception& error) {
    failed(internal_failure, error.what());
  } catch (...) {
    failed(internal_failure, "an exception outside the standard library");
  }
  return result;
}

// The held result; if the caller passed NULL, an empty one with the status of an internal failure.
const HeldResult& held_of(const ehl_result* result) {
  static const HeldResult none{.status = internal_failure};
  return result == nullptr ? none : result->held;
}

// errors: core::InputError if the caller passed NULL for a text that is needed.
const char* demanded(const char* text, const char* name) {
  if (text == nullptr) throw ehl::core::InputError(std::string(name) + " is NULL: a text is required");
  return text;
}

struct DeckSource {
  const char* text;
  const char* name;
  const char* const* overrides;
  size_t count;
  int threads;

  Case read() const {
    if (text == nullptr) demanded(name, "text and name of the deck are both required");
    if (overrides == nullptr && count > 0) throw ehl::core::InputError("overrides is NULL and count is not 0");
    std::vector<std::string> list;
    for (std::size_t k = 0; k < count; ++k)
      list.emplace_back(demanded(overrides[k], ("overrides[" + std::to_string(k) + "]").c_str()));
    return case_from(text, name == nullptr ? "deck" : name, list, threads > 0 ? threads : usable_cores());
  }
};

const char* kth(const std::vector<std::string>& list, size_t k) { return k < list.size() ? list[k].c_str() : nullptr; }

// The text that is returned belongs to the entry, and lives as long as the entry does.
const char* attribute_in(const HeldEntry& held, const std::string& name, const char* otherwise) {
  const std::string* text = ehl::results::attribute(held.entry, name);
  return text == nullptr ? otherwise : text->c_str();
}

void show(const HeldEntry& held, ehl_entry* entry) {
  const ehl::results::Entry& from = held.entry;
  *entry = {};
  entry->path = from.path.c_str();
  entry->kind = static_cast<int>(from.kind);
  entry->whole = from.whole ? 1 : 0;
  entry->unit = attribute_in(held, "unit", "");
  entry->meaning = attribute_in(held, "meaning", "");
  entry->error = held.error.c_str();
  entry->text = from.kind == ehl::results::Entry::Kind::text ? from.text.c_str() : nullptr;
  entry->rank = static_cast<int>(from.dims.size());
  for (std::size_t k = 0; k < from.dims.size(); ++k) {
    entry->dims[k] = from.dims[k];
    entry->strides[k] = held.strides[k];
  }
  entry->values = held.values;
}

const HeldEntry* at_path(const ehl_result* result, const char* path) {
  if (path == nullptr) return nullptr;
  const auto& entries = held_of(result).by_path;
  const auto found = entries.find(path);
  return found == entries.end() ? nullptr : found->second;
}

}  // namespace

extern "C" {

int ehl_api_version(void) { return EHL_API_VERSION; }

const char* ehl_version(void) try {
  static const std::string text = this_program() + ", for " + ehl::core::processor_level();
  return text.c_str();
} catch (...) {
  return "";
}

ehl_result* ehl_run(const char* deck, const char* name, const char* const* overrides, size_t count, int threads,
                    ehl_progress progress, void* context) {
  const DeckSource source{deck, name, overrides, count, threads};
  return filled([&](HeldResult& result) {
    Progress::Listener listener;
    if (progress != nullptr)
      listener = [=](double fraction, const std::string& text) {
        return progress(context, fraction, text.c_str()) == 0;
      };
    run_into(
        result, [&] { return source.read(); }, std::move(listener));
  });
}

ehl_result* ehl_check(const char* deck, const char* name, const char* const* overrides, size_t count, int threads) {
  const DeckSource source{deck, name, overrides, count, threads};
  return filled([&](HeldResult& result) { check_into(result, [&] { return source.read(); }); });
}

ehl_result* ehl_open(const char* path) {
  return filled([&](HeldResult& result) { open_into(result, demanded(path, "path"), std::nullopt); });
}

ehl_result* ehl_open_case(const char* path, size_t number) {
  return filled([&](HeldResult& result) { open_into(result, demanded(path, "path"), number); });
}

void ehl_free(ehl_result* result) { delete result; }

int ehl_status(const ehl_result* result) { return held_of(result).status; }
const char* ehl_message(const ehl_result* result, size_t k) { return kth(held_of(result).messages, k); }
const char* ehl_warning(const ehl_result* result, size_t k) { return kth(held_of(result).warnings, k); }
const char* ehl_report(const ehl_result* result) { return held_of(result).report.c_str(); }
const char* ehl_json(const ehl_result* result) { return held_of(result).json.c_str(); }

size_t ehl_entry_count(const ehl_result* result) { return held_of(result).entries.size(); }

int ehl_entry_at(const ehl_result* result, size_t k, ehl_entry* entry) try {
  if (entry == nullptr || k >= held_of(result).entries.size()) return 0;
  show(result->held.entries[k], entry);
  return 1;
} catch (...) {
  return 0;
}

int ehl_find(const ehl_result* result, const char* path, ehl_entry* entry) try {
  const HeldEntry* held = at_path(result, path);
  if (entry == nullptr || held == nullptr) return 0;
  show(*held, entry);
  return 1;
} catch (...) {
  return 0;
}

const char* ehl_attribute(const ehl_result* result, const char* path, const char* name) try {
  const HeldEntry* held = at_path(result, path);
  return held == nullptr || name == nullptr ? nullptr : attribute_in(*held, name, nullptr);
} catch (...) {
  return nullptr;
}

int ehl_save(ehl_result* result, const char* path, int overwrite) try {
  if (result == nullptr) return EHL_INTERNAL_FAILURE;
  if (path == nullptr) {
    result->held.messages.emplace_back("path is NULL: a text is required");
    return EHL_WRONG_INPUT;
  }
  return save(result->held, path, overwrite != 0);
} catch (...) {
  return EHL_INTERNAL_FAILURE;
}

const char* ehl_keys(void) try {
  static const std::string text = keys_json(catalogue());
  return text.c_str();
} catch (...) {
  return "";
}
}
