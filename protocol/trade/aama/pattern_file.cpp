#include "protocol/trade/aama/pattern_file.h"
#include "protocol/trade/text.h"

#include <algorithm>
#include <map>
#include <set>

#include "protocol/document/frame.h"
#include "protocol/json/json_text.h"
#include "protocol/trade/aama/blocks/pattern_blocks.h"
#include "protocol/trade/aama/finishing.h"
#include "protocol/trade/aama/grading.h"
#include "protocol/trade/aama/inserts.h"
#include "protocol/trade/aama/piece_texts.h"
#include "protocol/trade/aama/unfolding.h"
#include "protocol/trade/dxf/text_lines.h"
#include "protocol/trade/dxf/units.h"
#include "protocol/trade/rules/rule_table.h"

namespace selvage::protocol::trade::aama {
namespace {

class StyleReader {
 public:
  StyleReader(const dxf::DxfDrawing& drawing, const ReadingOptions& options, std::size_t bytes)
      : drawing_{drawing}, options_{options}, bytes_{bytes} {}

  Result<Style> read() {
    settle_encoding();
    read_file_texts();
    const auto unit = dxf::settle_unit(texts_, drawing_.insert_units, options_.unit, style_.notes);
    if (const auto error = read_blocks(unit ? *unit : 1)) return *error;
    if (blocks_.empty()) return no_pattern();
    if (!unit) return unit.error();
    for (PatternBlock& block : blocks_) scale(block, *unit);
    if (blocks::enlarge_shallow_notches(blocks_)) {
      style_.notes.push_back({"", "no notch is as deep as 1 mm: their depths and widths are read as centimetres"});
    }
    if (!loose_) follow_inserts(inserts_, encoding_, blocks_, style_.notes);
    share_texts();
    if (const auto error = make_pieces(*unit)) return *error;
    note_what_was_skipped();
    return std::move(style_);
  }

 private:
  void settle_encoding() {
    std::string bytes;
    std::size_t line = 0;
    const auto look_at = [&](std::string_view text, std::size_t on_line) {
      if (std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; })) return;
      if (line == 0) line = on_line;
      bytes.append(text).append("\n");
    };
    const auto look_at_all = [&](std::span<const dxf::Entity> entities) {
      for (const dxf::Entity& entity : entities) look_at(entity.text(1), entity.line);
    };
    look_at_all(drawing_.entities);
    for (const dxf::Block& block : drawing_.blocks) {
      look_at(block.name, block.line);
      look_at_all(block.entities);
    }
    const Encoding encoding = encoding_of(bytes, drawing_.code_page);
    encoding_ = encoding;
    if (encoding != Encoding::kUtf8) {
      style_.notes.push_back(note_at(line, "texts are read as " + std::string{name_of(encoding)}));
    }
  }

  void read_file_texts() {
    for (const dxf::Entity& entity : drawing_.entities) {
      read_texts(entity, [](const std::string&) { return true; });
    }
    style_.name = text_or_empty(texts_, "STYLE NAME");
    style_.sample_size = text_or_empty(texts_, "SAMPLE SIZE");
    for (const dxf::Block& block : drawing_.blocks) {  // some writers state it in every block instead
      for (const dxf::Entity& entity : block.entities) {
        if (texts_.contains("UNITS")) break;
        read_texts(entity, [](const std::string& key) { return key == "UNITS"; });
      }
    }
    for (const auto& [key, name] :
         {std::pair{"AUTHOR", "author"}, {"PRODUCT", "product"}, {"VERSION", "version"}, {"CREATION DATE", "date"}}) {
      if (const std::string& text = text_or_empty(texts_, key); !text.empty()) style_.attributes[name] = text;
    }
  }

  // Keeps the texts of the whole file whose keys are wanted.
  template <class Wanted>
  void read_texts(const dxf::Entity& entity, Wanted wanted) {
    if (entity.type != "TEXT" && entity.type != "MTEXT") return;
    for (const std::string& text : dxf::text_lines(entity, encoding_)) {
      auto pair = blocks::key_and_value(text);
      if (pair && wanted(pair->first)) texts_.emplace(std::move(*pair));
    }
  }

  std::optional<Error> read_blocks(double unit) {
    blocks::BlockReading reading{encoding_, {options_.tolerance / unit, bytes_}};
    auto read = blocks::read_pattern_blocks(drawing_, 1 / unit, reading);
    if (!read) return read.error();
    blocks_ = std::move(read->pieces);
    inserts_ = std::move(read->inserts);
    loose_ = read->loose;
    style_.notes.insert(style_.notes.end(), reading.notes.begin(), reading.notes.end());
    passed_over_ = std::move(reading.passed_over);
    return std::nullopt;
  }

  [[nodiscard]] Error no_pattern() const {
    const std::size_t count = drawing_.blocks.size();
    const std::string blocks = count == 0   ? "it has no block with"
                               : count == 1 ? "its only block lacks"
                                            : "none of its " + std::to_string(count) + " blocks has";
    return {ErrorCode::kUnknownFormat,
            "no pattern file: " + blocks +
                " a boundary on layer 1, as AAMA/ASTM D6673 requires, and no line on layer 1 lies outside of blocks.  "
                "Ask for plain DXF to read every closed outline as a piece",
            ""};
  }

  [[nodiscard]] std::string name_of_piece(const PatternBlock& block) {
    if (const std::string* name = block.text("PIECE NAME")) return *name;
    style_.notes.push_back(
        note_at(block.line, (loose_ ? "" : "block ") + in_quotes(block.name) +
                                (loose_ ? " has no Piece Name" : " has no Piece Name; the block's is taken")));
    return block.name;
  }

  [[nodiscard]] std::string size_of(const PatternBlock& block, const std::string& name) const {
    for (const char* key : {"SIZE", "SIZE NAME", "SAMPLE SIZE"}) {
      if (const std::string* size = block.text(key)) return *size;
    }
    if (block.name.size() > name.size() + 1 && block.name.starts_with(name) && block.name[name.size()] == '_') {
      return block.name.substr(name.size() + 1);
    }
    return style_.sample_size;
  }

  // In a nest the blocks of one piece share fields that only one of them contains, usually that of the sample size:
  // quantity, material, and which internal lines are not mirrored.
  void share_texts() {
    std::map<std::string, std::vector<std::size_t>> by_name;
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      names_.push_back(name_of_piece(blocks_[k]));
      sizes_.push_back(size_of(blocks_[k], names_.back()));
      by_name[names_.back()].push_back(k);
    }
    for (const auto& [name, members] : by_name) {
      const auto fullest = *std::max_element(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
        return blocks_[a].texts.size() < blocks_[b].texts.size();
      });
      const PatternBlock& said = blocks_[fullest];
      for (const std::size_t k : members) {
        PatternBlock& block = blocks_[k];
        for (const auto& [key, text] : said.texts) {
          if (!key.starts_with("SIZE")) block.texts.emplace(key, text);
        }
        if (block.unmirrored_spots.empty() && block.mirrored.size() == said.mirrored.size()) {
          block.mirrored = said.mirrored;
        }
      }
    }
  }

  std::optional<Error> make_pieces(double unit) {
    std::optional<rules::RuleTable> table;
    if (options_.rules) {
      auto read = rules::read_rule_table(*options_.rules);
      if (!read) return json::within("/rules", read.error());
      table = *std::move(read);
      style_.sizes = table->sizes;
      for (const Note& note : table->notes) style_.notes.push_back({"/rules" + note.field, note.text});
    } else {
      for (const std::string& size : sizes_) {
        if (std::find(style_.sizes.begin(), style_.sizes.end(), size) == style_.sizes.end())
          style_.sizes.push_back(size);
      }
    }
    if (auto error = check_sizes()) return error;
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      if (table) {
        if (auto error = grade_block(k, *table, table_unit(*table, unit))) return error;
      } else if (wanted(sizes_[k])) {
        if (auto error = finish(blocks_[k], k, sizes_[k], nullptr)) return error;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] bool wanted(const std::string& size) const {
    return options_.sizes.empty() ||
           std::find(options_.sizes.begin(), options_.sizes.end(), size) != options_.sizes.end();
  }

  [[nodiscard]] std::optional<Error> check_sizes() const {
    for (const std::string& size : options_.sizes) {
      if (std::find(style_.sizes.begin(), style_.sizes.end(), size) != style_.sizes.end()) continue;
      std::string known;
      for (const std::string& one : style_.sizes) known += (known.empty() ? "" : ", ") + one;
      return Error{ErrorCode::kOutOfRange, "size " + in_quotes(size) + " is not in the style; its sizes are " + known,
                   "/sizes"};
    }
    return std::nullopt;
  }

  [[nodiscard]] static double table_unit(const rules::RuleTable& table, double unit) {
    const auto said = dxf::unit_of_text(table.units);
    return said ? in_millimetres(*said) : unit;
  }

  // A block in each size of the table.
  std::optional<Error> grade_block(std::size_t k, const rules::RuleTable& table, double unit) {
    const std::string& sample = table.sample_size.empty() ? style_.sample_size : table.sample_size;
    bool first = true;
    for (std::size_t size = 0; size < table.sizes.size(); ++size) {
      if (!wanted(table.sizes[size])) continue;
      const Grading grading{table, size, unit, table.sizes[size] == sample, first};
      if (auto error = finish(blocks_[k], k, table.sizes[size], &grading)) return error;
      first = false;
    }
    return std::nullopt;
  }

  struct Grading {
    const rules::RuleTable& table;
    std::size_t size;
    double unit;
    bool sample;  // it is the size as drawn
    bool noted;   // only its oddities are reported, because those of the other sizes are the same
  };

  // The piece of a block in one size.
  std::optional<Error> finish(PatternBlock block, std::size_t k, const std::string& size, const Grading* grading) {
    std::vector<Note> notes;
    auto outline = boundary_of(block, notes);
    if (!outline) return outline.error();
    if (grading && !grading->sample) {
      grade(block, *outline, grading->table, grading->size, grading->unit, &notes);
    }
    const bool half = options_.fold == FoldRule::kLay && may_lie_on_fold(block, *outline, notes);
    if (options_.fold != FoldRule::kKeep && !half) {
      unfold(block, *outline, notes);
    } else {
      for (const auto& [from, to] : block.mirror_lines) {
        block.annotations.lines.push_back({document::LineKind::kMirror, false, {from, to}});
      }
    }
    if (!block.grains.empty()) {
      const auto& [from, to] = block.grains.front();
      block.annotations.lines.push_back({document::LineKind::kGrain, false, {from, to}});
    }
    if (doubled_area(*outline) < 0) std::reverse(outline->begin() + 1, outline->end());
    const document::Frame turn{false, turn_of_grain(block, notes), {}};
    PatternPiece piece = described(block, names_[k], notes);
    piece.size = size;
    for (const Spot& point : *outline) piece.outline.push_back(rounded(turn.apply(point)));
    piece.annotations = rounded(placed(block.annotations, turn));
    if (half)
      lay_on_fold(block, turn, piece);
    else if (block.inserted == 0 && block.inserted_mirrored > 0)
      mirror_piece(piece);
    check_extent(piece, notes);
    if (!grading || grading->noted) style_.notes.insert(style_.notes.end(), notes.begin(), notes.end());
    style_.pieces.push_back(std::move(piece));
    return std::nullopt;
  }

  void note_what_was_skipped() {
    for (const auto& [what, line] : passed_over_) style_.notes.push_back(note_at(line, what + " is not read"));
  }

  const dxf::DxfDrawing& drawing_;
  const ReadingOptions& options_;
  Texts texts_;        // of the file
  std::size_t bytes_;  // of the file
  Encoding encoding_{};
  std::map<std::string, std::size_t> passed_over_;  // a layer that is not read -> the first line of it
  std::vector<PatternBlock> blocks_;
  std::vector<blocks::PieceInsert> inserts_;
  bool loose_{};                            // there are no blocks: the pieces are drawn in ENTITIES
  std::vector<std::string> names_, sizes_;  // of the blocks
  Style style_;
};

}  // namespace

Result<Style> read_pattern(std::string_view text, const ReadingOptions& options) {
  const auto tags = dxf::read_tags(text);
  if (!tags) return tags.error();
  const auto drawing = dxf::read_drawing(*tags);
  if (!drawing) return drawing.error();
  return StyleReader{*drawing, options, text.size()}.read();
}

}  // namespace selvage::protocol::trade::aama
