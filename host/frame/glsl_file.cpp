#include "frame/glsl_file.h"

#include <algorithm>

#include <lumen/error.h>

namespace lumenshop {
namespace {

using Type = GlslToken::Type;

/// The significant tokens of a range, without space.
std::vector<const GlslToken*> significant(const std::vector<GlslToken>& tokens, std::size_t begin, std::size_t end) {
  std::vector<const GlslToken*> result;
  for (std::size_t i = begin; i < end; ++i)
    if (tokens[i].type != Type::space) result.push_back(&tokens[i]);
  return result;
}

std::string_view quoted(std::string_view directive) {
  const std::size_t open = directive.find('"');
  const std::size_t close = open == directive.npos ? open : directive.find('"', open + 1);
  return close == directive.npos ? std::string_view() : directive.substr(open + 1, close - open - 1);
}

/// The word after `#define`.
std::string_view defined_name(std::string_view directive) {
  const auto tokens = tokenize_glsl(directive.substr(1));
  const auto words = significant(tokens, 0, tokens.size());
  return words.size() > 1 && words[0]->is("define") ? words[1]->text : std::string_view();
}

/// Names that a list of declarators declares: identifiers followed by ; , = or [ outside of brackets.
void declarators(const std::vector<const GlslToken*>& words, std::size_t begin, std::size_t end, std::vector<std::string_view>& names) {
  int depth = 0;
  bool initializer = false;
  for (std::size_t i = begin; i < end; ++i) {
    const std::string_view text = words[i]->text;
    if (text == "(" || text == "{" || text == "[") ++depth;
    if (text == ")" || text == "}" || text == "]") --depth;
    if (depth == 0 && text == "=") initializer = true;
    if (depth == 0 && (text == "," || text == ";")) initializer = false;
    if (depth != 0 || initializer || words[i]->type != Type::identifier || i + 1 >= words.size()) continue;
    const std::string_view next = words[i + 1]->text;
    const bool has_type = i > begin && (words[i - 1]->type == Type::identifier || words[i - 1]->is(",") || words[i - 1]->is("]"));
    if (has_type && (next == ";" || next == "," || next == "=" || next == "[")) names.push_back(words[i]->text);
  }
}

}  // namespace

GlslFile::GlslFile(std::string name, std::string source) : name_(std::move(name)), source_(std::move(source)), tokens_(tokenize_glsl(source_)) {
  for (const GlslToken& token : tokens_)
    if (token.type == Type::identifier) mentioned_.insert(token.text);
  parse();
}

void GlslFile::parse() {
  Stage stage = Stage::any;
  std::size_t begin = 0;
  int depth = 0;
  bool body = false;  // the brace at depth 0 opens a function's body, which no semicolon follows
  std::string_view before_brace;
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    const GlslToken& token = tokens_[i];
    if (token.type == Type::space) {
      if (begin == i) ++begin;
      continue;
    }
    if (token.type == Type::directive) {
      if (depth == 0 && begin == i) {
        read_directive(token, i, stage);
        begin = i + 1;
      }
      continue;
    }
    if (token.is("{")) {
      if (depth == 0) body = before_brace == ")";
      ++depth;
    } else if (token.is("}")) {
      if (--depth < 0) throw lumen::Error(name_ + ":" + std::to_string(token.line), "'}' without '{'");
    }
    before_brace = token.text;
    if (depth == 0 && (token.is(";") || (token.is("}") && body))) {
      items_.push_back(read_item(begin, i + 1, stage));
      begin = i + 1;
    }
  }
  if (depth != 0) throw lumen::Error(name_, "'{' without '}' at the end of the file");
  if (begin < tokens_.size()) throw lumen::Error(name_ + ":" + std::to_string(tokens_[begin].line), "unfinished declaration; a ';' is missing");
}

void GlslFile::read_directive(const GlslToken& token, std::size_t index, Stage& stage) {
  const std::string_view text = token.text;
  const std::string where = name_ + ":" + std::to_string(token.line);
  if (text.find("include") == 1) {
    const std::string_view file = quoted(text);
    if (!file.starts_with("lib/")) throw lumen::Error(where, "#include takes a file of the shader library", "write #include \"lib/NAME.glsl\"");
    includes_.emplace_back(file);
  } else if (text.find("pragma stage vertex") == 1) {
    stage = Stage::vertex;
  } else if (text.find("pragma stage fragment") == 1) {
    stage = Stage::fragment;
  } else if (text.find("define") == 1) {
    Item item{index, index + 1, stage, {defined_name(text)}, {}, token.line};
    const auto words = tokenize_glsl(text.substr(1));
    for (const GlslToken& word : words)
      if (word.type == Type::identifier) item.uses.insert(word.text);
    items_.push_back(std::move(item));
  } else {
    throw lumen::Error(where, "only #include, #define and #pragma stage stand in a plugin's shader");
  }
}

GlslFile::Item GlslFile::read_item(std::size_t begin, std::size_t end, Stage stage) const {
  Item item{begin, end, stage, {}, {}, tokens_[begin].line};
  auto words = significant(tokens_, begin, end);
  for (const GlslToken* word : words)
    if (word->type == Type::identifier) item.uses.insert(word->text);
  std::size_t first = 0;
  if (words.size() > 1 && words[0]->is("layout")) {  // layout(...) may stand before anything
    while (first < words.size() && !words[first]->is(")")) ++first;
    ++first;
  }
  const auto find = [&](std::string_view symbol) {
    std::size_t i = first;
    while (i < words.size() && !words[i]->is(symbol)) ++i;
    return i;
  };
  const std::size_t parenthesis = find("("), brace = find("{"), equals = find("=");
  if (first < words.size() && words[first]->is("struct")) {
    item.names.push_back(words[first + 1]->text);
  } else if (brace < words.size() && brace < parenthesis && brace < equals) {  // uniform or buffer block
    item.names.push_back(words[brace - 1]->text);
    std::size_t close = words.size() - 1;
    while (!words[close]->is("}")) --close;
    if (words[close + 1]->type == Type::identifier) item.names.push_back(words[close + 1]->text);
    else declarators(words, brace + 1, close, item.names);
  } else if (parenthesis < words.size() && parenthesis < equals && parenthesis > first) {
    item.names.push_back(words[parenthesis - 1]->text);
  } else {
    declarators(words, first, words.size(), item.names);
  }
  return item;
}

bool GlslFile::declares(std::string_view function) const {
  return std::any_of(items_.begin(), items_.end(), [&](const Item& item) {
    return std::find(item.names.begin(), item.names.end(), function) != item.names.end();
  });
}

std::string GlslFile::emit(Stage stage, std::span<const std::string_view> entries, std::string_view prefix, int number) const {
  const bool all = entries.empty();
  std::set<std::string_view> renamed, wanted(entries.begin(), entries.end());
  if (!all) {
    for (const Item& item : items_) renamed.insert(item.names.begin(), item.names.end());
    renamed.insert("Properties");
  }
  std::vector<bool> taken(items_.size(), all);
  for (bool grew = !all; grew;) {
    grew = false;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const Item& item = items_[i];
      const bool of_stage = item.stage == Stage::any || item.stage == stage;
      const bool reached = item.names.empty() || std::any_of(item.names.begin(), item.names.end(), [&](auto n) { return wanted.contains(n); });
      if (taken[i] || !of_stage || !reached) continue;
      taken[i] = grew = true;
      wanted.insert(item.uses.begin(), item.uses.end());
    }
  }
  std::string text;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (!taken[i] || (items_[i].stage != Stage::any && items_[i].stage != stage)) continue;
    text += "#line " + std::to_string(number * lines_per_file + items_[i].line) + "\n";
    text += text_of(items_[i], renamed, prefix) + "\n";
  }
  return text;
}

std::string GlslFile::text_of(const Item& item, const std::set<std::string_view>& renamed, std::string_view prefix) const {
  std::string text;
  const auto append = [&](const std::vector<GlslToken>& tokens, std::size_t begin, std::size_t end, bool in_struct) {
    std::string_view previous;
    for (std::size_t i = begin; i < end; ++i) {
      const GlslToken& token = tokens[i];
      if (token.type == Type::identifier && renamed.contains(token.text) && previous != ".") {
        std::size_t next = i + 1;
        while (next < end && tokens[next].type == Type::space) ++next;
        const bool ends_declarator = next < end && (tokens[next].is(";") || tokens[next].is(",") || tokens[next].is("["));
        const bool is_field = in_struct && ends_declarator && previous != "{" && previous != ";";
        if (!is_field) text += prefix;
      }
      text += token.text;
      if (token.type != Type::space) previous = token.text;
    }
  };
  const GlslToken& first = tokens_[item.begin];
  if (first.type == Type::directive) {
    text += "#";
    const auto words = tokenize_glsl(first.text.substr(1));
    append(words, 0, words.size(), false);
  } else {
    append(tokens_, item.begin, item.end, first.is("struct"));
  }
  return text;
}

}  // namespace lumenshop
