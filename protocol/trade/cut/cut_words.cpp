#include "protocol/trade/cut/cut_words.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "protocol/json/json_text.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::cut {
namespace {

constexpr double kFarthest = 1e9;  // of the file's unit, either way

struct Word {
  char letter{};
  double number{};
};

// The words of a block; none when it is text.  A letter without a number, such as A, has the number 0.
std::optional<std::vector<Word>> words_of(std::string_view block) {
  std::vector<Word> words;
  for (std::size_t at = 0; at < block.size();) {
    const auto c = static_cast<unsigned char>(block[at]);
    if (c <= ' ' || c == '%') {  // % begins and ends a tape
      ++at;
      continue;
    }
    if (!std::isupper(c)) return std::nullopt;
    ++at;
    while (at < block.size() && block[at] == ' ') ++at;  // "X 100 Y 200"
    const bool plus = at < block.size() && block[at] == '+';
    double number = 0;
    const char* first = block.data() + at + (plus ? 1 : 0);
    const auto [end, fault] = std::from_chars(first, block.data() + block.size(), number, std::chars_format::fixed);
    if (fault == std::errc{})
      at = static_cast<std::size_t>(end - block.data());
    else if (fault != std::errc::invalid_argument || plus)
      return std::nullopt;
    if (!std::isfinite(number)) return std::nullopt;  // "nan" and "inf" are text
    words.push_back({static_cast<char>(c), std::clamp(number, -kFarthest, kFarthest)});
  }
  return words;
}

bool only_coordinates(const std::vector<Word>& words) {
  return !words.empty() && std::all_of(words.begin(), words.end(),
                                       [](const Word& word) { return word.letter == 'X' || word.letter == 'Y'; });
}

// Executes the blocks one after another.
class Interpreter {
 public:
  explicit Interpreter(std::string_view text) : text_{text}, encoding_{encoding_of(text)} {}

  CutCommands run() {
    while (const auto block = next()) {
      const auto words = words_of(*block);
      if (!words) {
        note_unread(*block);
        continue;
      }
      for (const Word& word : *words) {
        if (!obey(word, *words)) return finish();
      }
    }
    return finish();
  }

 private:
  std::optional<std::string_view> next() {
    while (!text_.empty()) {
      const std::size_t end = std::min(text_.find('*'), text_.size());
      const std::string_view block = trimmed(text_.substr(0, end));
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++number_;
      if (!block.empty()) return block;
    }
    return std::nullopt;
  }

  // Returns false at the end of the program.
  bool obey(const Word& word, const std::vector<Word>& block) {
    switch (word.letter) {
      case 'X':
        at_.x = word.number;
        moved_ = true;
        break;
      case 'Y':
        at_.y = word.number;
        moved_ = true;
        break;
      case 'N': begin_piece(static_cast<std::size_t>(std::max(0.0, word.number))); break;
      case 'D':
        if (word.number == 1) lower_pen();
        if (word.number == 2) pen_down_ = false;
        break;
      case 'R': return obey_function(43, block);
      case 'A': raise(); break;
      case 'B': lower(); break;
      case 'G':
        if (word.number == 70 || word.number == 71) commands_.unit = static_cast<int>(word.number);
        if (word.number == 91) incremental_ = true;
        break;
      case 'M': return obey_function(static_cast<int>(std::clamp(word.number, -1.0, 1e6)), block);
      default: break;
    }
    // A block of one or two coordinates is one move, made at its last word.
    if (moved_ && &word == &block.back()) move();
    return true;
  }

  bool obey_function(int function, const std::vector<Word>& block) {
    const bool placed = moved_;
    if (moved_) move();
    switch (function) {
      case 0:
      case 30: return false;
      case 14: lower(); break;
      case 15: raise(); break;
      case 20:
        if (const auto text = next()) commands_.message = decoded(*text, encoding_);
        break;
      case 31: read_label(placed || block.size() > 1); break;
      case 70: note_origin(); break;
      case 43:
      case 44: piece().drills.push_back(at_); break;
      default: break;
    }
    return true;
  }

  // The label follows in a separate block; its position is before it or in between.
  void read_label(bool placed) {
    Spot at = at_;
    auto text = next();
    if (text && !placed) {
      const auto words = words_of(*text);
      if (words && only_coordinates(*words)) {
        for (const Word& word : *words) (word.letter == 'X' ? at.x : at.y) = word.number;
        text = next();
      }
    }
    if (text) piece().labels.push_back({decoded(*text, encoding_), at});
  }

  CutPiece& piece() {
    if (commands_.pieces.empty()) commands_.pieces.emplace_back();
    return commands_.pieces.back();
  }

  void begin_piece(std::size_t number) {
    raise();
    commands_.numbered = true;
    commands_.pieces.push_back({{}, {}, {}, {}, number});
    pen_down_ = false;
  }

  void lower() {
    if (down_) return;
    down_ = true;
    piece().runs.push_back({{at_}, {}, false, number_});
  }
  // Unlike the knife, the pen draws the move of the block in which it is lowered [RS-274-D].
  void lower_pen() {
    if (pen_down_) return;
    pen_down_ = true;
    piece().drawn.push_back({{here_}, {}, false, number_});
  }
  void raise() { down_ = false; }
  void move() {
    moved_ = false;
    here_ = at_;
    const auto extend = [&](std::vector<Run>& runs) {
      if (runs.back().points.back() != at_) runs.back().points.push_back(at_);
    };
    if (down_) extend(piece().runs);
    if (pen_down_) extend(piece().drawn);
  }

  // M70 sets the origin before anything is cut; standard coordinates are absolute, so that there is only one.
  void note_origin() {
    const auto begun = [](const CutPiece& piece) { return !piece.runs.empty() || !piece.drawn.empty(); };
    if (std::none_of(commands_.pieces.begin(), commands_.pieces.end(), begun)) return;
    commands_.notes.push_back({"/block/" + std::to_string(number_),
                               "M70 after the first cut is ignored: all coordinates are taken from one origin"});
  }

  void note_unread(std::string_view block) {
    constexpr std::size_t kMostNotes = 20;
    if (++unread_ > kMostNotes) return;
    commands_.notes.push_back({"/block/" + std::to_string(number_),
                               json::shortened(Json(decoded(block, encoding_))) + " is not a command; ignored"});
  }

  CutCommands finish() {
    if (incremental_) commands_.notes.push_back({"", "G91 is ignored: coordinates are absolute in ASTM D6672"});
    const auto draws_nothing = [](const CutPiece& piece) { return piece.drawn.empty(); };
    const auto cuts_nothing = [](const CutPiece& piece) {
      return std::all_of(piece.runs.begin(), piece.runs.end(), [](const Run& run) { return run.points.size() < 2; });
    };
    std::vector<CutPiece>& pieces = commands_.pieces;
    if (std::all_of(pieces.begin(), pieces.end(), cuts_nothing) &&
        !std::all_of(pieces.begin(), pieces.end(), draws_nothing)) {
      commands_.notes.push_back({"", "nothing is cut: what the pen draws (D1) is taken for what the knife cuts"});
      for (CutPiece& piece : pieces) std::swap(piece.runs, piece.drawn);
    }
    std::erase_if(pieces, [](const CutPiece& piece) { return piece.runs.empty(); });
    return std::move(commands_);
  }

  std::string_view text_;
  Encoding encoding_;
  std::size_t number_{}, unread_{};
  Spot at_, here_;  // as the last coordinates say, and as the last move left it
  bool moved_{}, down_{}, pen_down_{}, incremental_{};
  CutCommands commands_;
};

}  // namespace

bool looks_like_cut(std::string_view text) {
  constexpr std::size_t kEnough = 4;  // blocks of words
  constexpr std::size_t kLookedAt = 2000;
  constexpr std::size_t kLongest = 80;  // of a block
  text = trimmed(text.substr(0, kLookedAt));
  std::size_t blocks = 0, read = 0;
  while (blocks < kEnough) {
    const std::size_t end = text.find('*');
    if (end > kLongest) break;  // or there is none: npos
    ++blocks;
    if (words_of(text.substr(0, end)) && end > 0) ++read;
    text.remove_prefix(end + 1);
  }
  return blocks == kEnough && read >= kEnough - 1;
}

CutCommands read_commands(std::string_view text) {
  return Interpreter{text}.run();
}

}  // namespace selvage::protocol::trade::cut
