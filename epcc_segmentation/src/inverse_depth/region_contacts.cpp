// SPDX-License-Identifier: BSD-3-Clause
// Finds neighbouring regions at the borders of the labels.
#include "inverse_depth/region_contacts.h"

#include <algorithm>
#include <utility>

#include "parallel_for.h"

namespace epcc {

Contact& Contact::operator+=(const Contact& other) {
  count += other.count;
  for (int k = 0; k < 6; ++k) rays[k] += other.rays[k];
  return *this;
}

double Contact::squares(const Eigen::Vector3d& q) const {
  const double x = q.x(), y = q.y(), z = q.z();
  return x * (rays[0] * x + rays[1] * y + rays[2] * z) + y * (rays[1] * x + rays[3] * y + rays[4] * z) +
         z * (rays[2] * x + rays[4] * y + rays[5] * z);
}

void RegionContacts::clear() {
  table.clear();
  contacts.clear();
}

RegionContacts& RegionContacts::operator+=(const RegionContacts& other) {
  const std::vector<RegionPair>& pairs = other.table.pairs();
  for (std::size_t k = 0; k < pairs.size(); ++k) (*this)[pairs[k]] += other.contacts[k];
  return *this;
}

const Contact* RegionContacts::find(const RegionPair& pair) const {
  const int number = table.numberOf(pair);
  return number < 0 ? nullptr : &contacts[static_cast<std::size_t>(number)];
}

namespace {

// However many threads there are, contacts are summed in as many bands of rows: one order of all sums. They are few,
// for what they find has to be brought together.
constexpr int kContactBands = 2;

/// Finds where labels follow each other on a row or column. Inside a region nothing needs to be looked at: each row
/// tells by bits where a label begins or ends, to the left and above.
class ContactSearch {
 public:
  ContactSearch(const InverseDepthImage& image, int bridge, double residual, const RegionMap& map,
                ContactSearchMemory& memory, RegionContacts& contacts)
      : image_(image),
        bridge_(bridge),
        residual2_(residual * residual),
        labels_(map.labels.data()),
        memory_(memory),
        contacts_(contacts) {}

  /// The places whose second pixel is in the rows [begin, end).
  void search(int begin, int end) {
    memory_.borders.resize(image_.width);
    memory_.upper_labelled.assign(wordsOf(image_.width), 0);
    memory_.last_row.assign(static_cast<std::size_t>(image_.width), -bridge_ - 2);  // out of reach
    for (int row = std::max(0, begin - bridge_ - 1); row < begin; ++row) lookAhead(row);
    for (int row = begin; row < end; ++row) {
      memory_.borders.mark(labels_, image_.width, image_.height, row);
      listPixels();
      addNeighbours(row);
      for (const int column : memory_.left_gap) meetAcross(row, column, row, lastLabelled(column), 1);
      for (const int column : memory_.above_gap)
        meetAcross(row, column, lastRow(column), column, static_cast<std::size_t>(image_.width));
      for (const int column : memory_.ends) lastRow(column) = row - 1;
      if (image_.closes_round) meetRound(row);
      std::swap(memory_.upper_labelled, memory_.borders.labelled);
    }
  }

 private:
  /// What the rows above a band tell of its first ones.
  void lookAhead(int row) {
    markLabelled(labels_, image_.width, row, memory_.borders.labelled);
    memory_.ends.clear(image_.width);
    for (std::size_t word = 0; word < memory_.upper_labelled.size(); ++word)
      memory_.ends.add(memory_.upper_labelled[word] & ~memory_.borders.labelled[word], word);
    for (const int column : memory_.ends) lastRow(column) = row - 1;
    std::swap(memory_.upper_labelled, memory_.borders.labelled);
  }

  void listPixels() {
    for (PixelList* list : {&memory_.left, &memory_.above, &memory_.left_gap, &memory_.above_gap, &memory_.ends})
      list->clear(image_.width);
    for (std::size_t word = 0; word < memory_.upper_labelled.size(); ++word) {
      const std::uint64_t labelled = memory_.borders.labelled[word];
      const std::uint64_t left = memory_.borders.left[word] & labelled;
      const std::uint64_t above = memory_.borders.above[word] & labelled;
      const std::uint64_t left_labelled = fromLeft(memory_.borders.labelled, word);
      const std::uint64_t upper_labelled = memory_.upper_labelled[word];
      memory_.left.add(left & left_labelled, word);
      memory_.above.add(above & upper_labelled, word);
      memory_.left_gap.add(left & ~left_labelled, word);
      memory_.above_gap.add(above & ~upper_labelled, word);
      memory_.ends.add(upper_labelled & ~labelled, word);
    }
  }

  int& lastRow(int column) { return memory_.last_row[static_cast<std::size_t>(column)]; }

  /// The last pixel with a label before an unlabelled one on this row.
  int lastLabelled(int column) const {
    auto word = static_cast<std::size_t>(column) / 64;
    std::uint64_t bits = memory_.borders.labelled[word] & ((std::uint64_t{1} << column % 64) - 1);
    while (bits == 0 && word > 0) bits = memory_.borders.labelled[--word];
    return bits == 0 ? -bridge_ - 2 : static_cast<int>(64 * word) + 63 - __builtin_clzll(bits);
  }

  /// The pixels that differ from the one to the left, and from the one above.
  void addNeighbours(int row) {
    const double* across = image_.across.data();
    const double* forward = image_.forward.data();
    const auto width = static_cast<std::ptrdiff_t>(image_.width);
    const std::int32_t* label = labels_ + image_.index(row, 0);
    const float* weight = image_.weight.data() + image_.index(row, 0);
    const double along = image_.along[static_cast<std::size_t>(row)];
    const auto weightOf = [weight](std::ptrdiff_t a, std::ptrdiff_t b) {
      return 0.5 * (static_cast<double>(weight[a]) + static_cast<double>(weight[b]));
    };
    for (const int column : memory_.left)
      contacts_[{label[column - 1], label[column]}].add(weightOf(column, column - 1),
                                                        0.5 * (across[column] + across[column - 1]), along,
                                                        0.5 * (forward[column] + forward[column - 1]));
    if (row == 0) return;  // nothing is above
    const double between = 0.5 * (along + image_.along[static_cast<std::size_t>(row) - 1]);
    for (const int column : memory_.above)
      contacts_[{label[column - width], label[column]}].add(weightOf(column, column - width), across[column], between,
                                                            forward[column]);
  }

  void addContact(int row, int column, int other_row, int other_column) {
    const RegionPair pair(labels_[image_.index(other_row, other_column)], labels_[image_.index(row, column)]);
    contacts_[pair].add(image_, row, column, other_row, other_column);
  }

  void meetAcross(int row, int column, int other_row, int other_column, std::size_t step) {
    if (row - other_row > bridge_ + 1 || column - other_column > bridge_ + 1) return;
    const std::size_t first = image_.index(other_row, other_column), second = image_.index(row, column);
    if (labels_[first] == labels_[second] || seesBehind(first, second, step)) return;
    addContact(row, column, other_row, other_column);
  }

  /// The first and the last label of a row of a full turn follow each other, too.
  void meetRound(int row) {
    const std::int32_t* label = labels_ + image_.index(row, 0);
    const int width = image_.width;
    int first = 0, last = width - 1;
    while (first <= bridge_ && first < last && label[first] == 0) ++first;
    while (width - 1 - last <= bridge_ && first < last && label[last] == 0) --last;
    if (label[first] == 0 || label[last] == 0 || label[first] == label[last]) return;
    if (first + width - last > bridge_ + 1) return;
    const float farther = std::min(image_.w[image_.index(row, first)], image_.w[image_.index(row, last)]);
    for (int between = last + 1; between < width; ++between)
      if (liesBehind(farther, row, between)) return;
    for (int between = 0; between < first; ++between)
      if (liesBehind(farther, row, between)) return;
    addContact(row, first, row, last);
  }

  bool liesBehind(float farther, int row, int column) const {
    const std::size_t pixel = image_.index(row, column);
    const double error = static_cast<double>(farther) - static_cast<double>(image_.w[pixel]);
    return image_.w[pixel] > 0.0f && error > 0.0 &&
           error * error * static_cast<double>(image_.weight[pixel]) > residual2_;
  }

  /// Something between the two pixels lies farther away than both: a groove or a gap parts them.
  bool seesBehind(std::size_t first, std::size_t second, std::size_t step) const {
    const std::size_t farther = image_.w[first] < image_.w[second] ? first : second;
    const auto weight = static_cast<double>(image_.weight[farther]);
    for (std::size_t between = first + step; between < second; between += step) {
      const double error = static_cast<double>(image_.w[farther]) - static_cast<double>(image_.w[between]);
      if (image_.w[between] > 0.0f && error > 0.0 && error * error * weight > residual2_) return true;
    }
    return false;
  }

  const InverseDepthImage& image_;
  int bridge_;
  double residual2_;
  const std::int32_t* labels_;
  ContactSearchMemory& memory_;
  RegionContacts& contacts_;
};

}  // namespace

void findContacts(const InverseDepthImage& image, int bridge, double residual, const RegionMap& map,
                  std::vector<ContactSearchMemory>& memory, RegionContacts& contacts, int threads) {
  memory.resize(kContactBands);
  sharedFor(kContactBands, threads, [&](int /*thread*/, int first, int end) {
    for (int band = first; band < end; ++band) {
      ContactSearchMemory& own = memory[static_cast<std::size_t>(band)];
      RegionContacts& found = band == 0 ? contacts : own.contacts;
      found.clear();
      ContactSearch(image, bridge, residual, map, own, found)
          .search(image.height * band / kContactBands, image.height * (band + 1) / kContactBands);
    }
  });
  for (std::size_t band = 1; band < memory.size(); ++band) contacts += memory[band].contacts;
}

}  // namespace epcc
