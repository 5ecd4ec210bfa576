#include "limn/search/store.h"

#ifdef LIMN_HAS_SQLITE
#include <sqlite3.h>
#endif

#include <mutex>
#include <utility>

#include <fmt/core.h>

namespace limn::search {

#ifdef LIMN_HAS_SQLITE
namespace {

/// What SQLite says went wrong.
Error failure(const std::string& path, sqlite3* file, int code) {
  if (code == SQLITE_BUSY || code == SQLITE_LOCKED)
    return {"another limn study is at work on it", "wait for it, or give another folder", path};
  if (code == SQLITE_NOTADB) return {"it is no store of a study", "give another folder", path};
  return {fmt::format("the store fails: {}",
                      file != nullptr ? sqlite3_errmsg(file) : sqlite3_errstr(code)),
          "see that the disk has room and that the folder can be written", path};
}

/// A name in SQL.
std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + '"';
}

struct Close {
  void operator()(sqlite3* file) const { sqlite3_close_v2(file); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Statement = std::unique_ptr<sqlite3_stmt, Close>;

/// Not "bind": std::bind would take texts that are moved.
void bind_text(sqlite3_stmt* to, int column, const std::string& text) {
  sqlite3_bind_text(to, column, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
}

std::string text_of(sqlite3_stmt* row, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(row, column));
  return text == nullptr
             ? std::string()
             : std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(row, column)));
}

bool is_null(sqlite3_stmt* row, int column) {
  return sqlite3_column_type(row, column) == SQLITE_NULL;
}

std::optional<Truth> truth_named(const std::string& text) {
  for (const Truth truth : {Truth::no, Truth::yes, Truth::undecided})
    if (to_string(truth) == text) return truth;
  return std::nullopt;
}

constexpr int kFixedColumns = 7;  // key … seconds

/// Columns after the fixed ones: coordinates as exact text, objectives, demands. Numbered, as SQL
/// does not tell capitals from small letters.
std::string make_table(const Study& study) {
  std::string sql =
      "CREATE TABLE IF NOT EXISTS points (key TEXT PRIMARY KEY, generation INTEGER, place INTEGER, "
      "feasible INTEGER, reason TEXT, violation REAL, seconds REAL";
  for (std::size_t i = 0; i < study.coordinates.size(); ++i)
    sql += ", " + quoted(fmt::format("free {} {}", i + 1, study.coordinates[i].label())) + " TEXT";
  for (std::size_t i = 0; i < study.objectives.size(); ++i)
    sql += ", " + quoted(fmt::format("objective {} {}", i + 1, study.objectives[i].value.text())) +
           " REAL";
  for (std::size_t i = 0; i < study.demands.size(); ++i)
    sql += ", " + quoted(fmt::format("require {} {}", i + 1, study.demands[i].text)) + " TEXT";
  return sql + ") WITHOUT ROWID";
}

}  // namespace

struct Store::File {
  std::string path;
  std::unique_ptr<sqlite3, Close> database;
  Statement insert;
  std::mutex mutex;

  Status run(const std::string& sql) {
    const int code = sqlite3_exec(database.get(), sql.c_str(), nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) return failure(path, database.get(), code);
    return Done{};
  }
  Result<Statement> prepare(const std::string& sql) {
    sqlite3_stmt* made = nullptr;
    const int code = sqlite3_prepare_v2(database.get(), sql.c_str(), -1, &made, nullptr);
    if (code != SQLITE_OK) return failure(path, database.get(), code);
    return Statement(made);
  }
  Status begin(const Study& study, bool restart);
  Result<std::string> identity();
};

Result<std::string> Store::File::identity() {
  Result<Statement> read = prepare("SELECT value FROM study WHERE name = 'identity'");
  if (!read) return read.error();
  return sqlite3_step(read->get()) == SQLITE_ROW ? text_of(read->get(), 0) : std::string();
}

Status Store::File::begin(const Study& study, bool restart) {
  // a log beside the file, kept whole by the operating system when the process is killed
  for (const char* sql : {"PRAGMA locking_mode = EXCLUSIVE", "PRAGMA journal_mode = WAL",
                          "PRAGMA synchronous = NORMAL", "BEGIN IMMEDIATE",
                          "CREATE TABLE IF NOT EXISTS study (name TEXT PRIMARY KEY, value TEXT)"})
    if (Status status = run(sql); !status) return status;
  const Result<std::string> before = identity();
  if (!before) return before.error();
  const std::string own = study.identity();
  if (!before->empty() && *before != own) {
    if (!restart)
      return Error{"the folder holds the points of another study, or of this one before a change",
                   "give another folder, or --restart to throw those points away", path};
    if (Status status = run("DROP TABLE IF EXISTS points"); !status) return status;
  } else if (restart) {
    if (Status status = run("DROP TABLE IF EXISTS points"); !status) return status;
  }
  if (Status status = run(make_table(study)); !status) return status;
  Result<Statement> write = prepare("INSERT OR REPLACE INTO study VALUES (?, ?)");
  if (!write) return write.error();
  for (const auto& [name, value] :
       {std::pair<std::string, std::string>{"identity", own}, {"text", study.text}}) {
    bind_text(write->get(), 1, name);
    bind_text(write->get(), 2, value);
    if (const int code = sqlite3_step(write->get()); code != SQLITE_DONE)
      return failure(path, database.get(), code);
    sqlite3_reset(write->get());
  }
  write->reset();
  return run("COMMIT");
}

Store::Store(std::unique_ptr<File> file) : file_(std::move(file)) {}
Store::~Store() = default;
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;

Result<Store> Store::open(const std::string& path, const Study& study, bool restart) {
  auto file = std::make_unique<File>();
  file->path = path;
  sqlite3* opened = nullptr;
  const int code =
      sqlite3_open_v2(path.c_str(), &opened, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  file->database.reset(opened);
  if (code != SQLITE_OK) return failure(path, opened, code);
  if (Status status = file->begin(study, restart); !status) return status.error();
  std::string marks = "?";
  const std::size_t columns =
      kFixedColumns + study.coordinates.size() + study.objectives.size() + study.demands.size();
  for (std::size_t i = 1; i < columns; ++i) marks += ", ?";
  Result<Statement> insert = file->prepare("INSERT INTO points VALUES (" + marks + ")");
  if (!insert) return insert.error();
  file->insert = *std::move(insert);
  Store store(std::move(file));
  if (Status status = store.load(study); !status) return status.error();
  return store;
}

Status Store::load(const Study& study) {
  Result<Statement> read = file_->prepare("SELECT * FROM points");
  if (!read) return read.error();
  sqlite3_stmt* row = read->get();
  int code = SQLITE_OK;
  while ((code = sqlite3_step(row)) == SQLITE_ROW) {
    Outcome outcome;
    outcome.feasible = sqlite3_column_int(row, 3) != 0;
    outcome.reason = text_of(row, 4);
    outcome.violation = sqlite3_column_double(row, 5);
    outcome.seconds = sqlite3_column_double(row, 6);
    int column = kFixedColumns + static_cast<int>(study.coordinates.size());
    for (std::size_t i = 0; i < study.objectives.size(); ++i, ++column)
      outcome.objectives.push_back(is_null(row, column)
                                       ? std::nullopt
                                       : std::optional<double>(sqlite3_column_double(row, column)));
    for (std::size_t i = 0; i < study.demands.size(); ++i, ++column)
      outcome.demands.push_back(truth_named(text_of(row, column)));
    known_.emplace(text_of(row, 0), std::move(outcome));
  }
  if (code != SQLITE_DONE) return failure(file_->path, file_->database.get(), code);
  return Done{};
}

Status Store::add(const Evaluated& one) {
  const std::scoped_lock lock(file_->mutex);
  sqlite3_stmt* row = file_->insert.get();
  const Outcome& outcome = one.outcome;
  sqlite3_reset(row);
  sqlite3_clear_bindings(row);  // what is not bound is null
  bind_text(row, 1, point_key(one.point));
  sqlite3_bind_int(row, 2, one.generation);
  sqlite3_bind_int(row, 3, one.place);
  sqlite3_bind_int(row, 4, outcome.feasible ? 1 : 0);
  bind_text(row, 5, outcome.reason);
  sqlite3_bind_double(row, 6, outcome.violation);
  sqlite3_bind_double(row, 7, outcome.seconds);
  int column = kFixedColumns;
  for (const Rational& value : one.point) bind_text(row, ++column, to_string(value));
  for (const std::optional<double>& value : outcome.objectives)
    if (++column; value) sqlite3_bind_double(row, column, *value);
  for (const std::optional<Truth>& truth : outcome.demands)
    if (++column; truth) bind_text(row, column, std::string(to_string(*truth)));
  const int code = sqlite3_step(row);
  sqlite3_reset(row);
  if (code != SQLITE_DONE) return failure(file_->path, file_->database.get(), code);
  return Done{};
}

const Outcome* Store::find(const std::string& key) const {
  const auto found = known_.find(key);
  return found == known_.end() ? nullptr : &found->second;
}

#else

struct Store::File {};
Store::Store(std::unique_ptr<File> file) : file_(std::move(file)) {}
Store::~Store() = default;
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;

Result<Store> Store::open(const std::string& path, const Study&, bool) {
  return Error{"limn was built without SQLite, which studies are kept by",
               "build with libsqlite3-dev", path};
}
Status Store::load(const Study&) { return Done{}; }
Status Store::add(const Evaluated&) { return Done{}; }
const Outcome* Store::find(const std::string&) const { return nullptr; }

#endif

}  // namespace limn::search
