#include "storage/archive/xdmf.h"

#include <sstream>

namespace rouleau::storage {

namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

struct Array {
  std::string path;
  std::vector<int> record;  // one or two dimensions
  std::string number;       // XDMF's attributes for its type
};

const std::string real = R"(NumberType="Float" Precision="4")";

std::string joined(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += " " + std::to_string(number);
  return text.substr(1);
}

std::vector<int> with_first(int first, const std::vector<int>& rest) {
  std::vector<int> numbers{first};
  numbers.insert(numbers.end(), rest.begin(), rest.end());
  return numbers;
}

class Document {
 public:
  explicit Document(const XdmfContent& content) : content_(content) { text_.precision(17); }

  std::string text() {
    text_ << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n";
    over_time("particles", [this](int k) { particles(k); });
    for (std::size_t c = 0; c < content_.nodes_per_cell.size(); ++c) {
      over_time("cell" + std::to_string(c), [this, c](int k) { outline(static_cast<int>(c), k); });
    }
    text_ << "</Domain>\n</Xdmf>\n";
    return text_.str();
  }

 private:
  template <class AtFrame>
  void over_time(const std::string& name, AtFrame&& at_frame) {
    text_ << "<Grid Name=\"" << name << "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
    for (std::size_t k = 0; k < content_.times.size(); ++k) {
      text_ << "<Grid Name=\"" << name << "\" GridType=\"Uniform\">\n<Time Value=\"" << content_.times[k]
            << "\"/>\n";
      at_frame(static_cast<int>(k));
      text_ << "</Grid>\n";
    }
    text_ << "</Grid>\n";
  }

  void particles(int k) {
    const int n = content_.capacity;
    const std::string at = "/particles/trajectory/";
    text_ << "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"" << n << "\"/>\n";
    geometry("XYZ", {at + "position/value", {n, 3}, real}, k);
    if (content_.velocity) attribute("velocity", "Vector", {at + "velocity/value", {n, 3}, real}, k);
    if (content_.pressure) attribute("pressure", "Scalar", {at + "pressure/value", {n}, real}, k);
    attribute("species", "Scalar", {at + "species/value", {n}, R"(NumberType="UChar" Precision="1")"}, k);
    attribute("alive", "Scalar", {at + "alive/value", {n}, R"(NumberType="UChar" Precision="1")"}, k);
    attribute("cell", "Scalar", {at + "cell/value", {n}, R"(NumberType="Int" Precision="4")"}, k);
    attribute("id", "Scalar", {at + "id/value", {n}, R"(NumberType="Int" Precision="8")"}, k);
  }

  void outline(int cell, int k) {
    const int n = content_.nodes_per_cell[static_cast<std::size_t>(cell)];
    text_ << "<Topology TopologyType=\"Polyline\" NodesPerElement=\"" << n + 1
          << "\" NumberOfElements=\"1\">\n<DataItem Format=\"XML\" NumberType=\"Int\" Dimensions=\"1 "
          << n + 1 << "\">";
    for (int i = 0; i < n; ++i) text_ << i << ' ';
    text_ << "0</DataItem>\n</Topology>\n";
    const std::string at = "/outlines/cell" + std::to_string(cell) + "/";
    geometry("XY", {at + "value", {n, 2}, real}, k);
    for (const MembraneField& field : content_.membrane_fields) {
      attribute(field.name, "Scalar", {at + field.name, {n}, real}, k);
    }
  }

  void geometry(const std::string& type, const Array& array, int k) {
    text_ << "<Geometry GeometryType=\"" << type << "\">\n";
    record(array, k);
    text_ << "</Geometry>\n";
  }

  void attribute(const std::string& name, const std::string& type, const Array& array, int k) {
    text_ << "<Attribute Name=\"" << name << "\" AttributeType=\"" << type << "\" Center=\"Node\">\n";
    record(array, k);
    text_ << "</Attribute>\n";
  }

  /// Record k of an array [T][record...], as a hyperslab: start, stride and count.
  void record(const Array& array, int k) {
    const std::size_t rank = array.record.size() + 1;
    const std::vector<int> zeros(rank - 1, 0);
    const std::vector<int> ones(rank, 1);
    const int frames = static_cast<int>(content_.times.size());
    text_ << "<DataItem ItemType=\"HyperSlab\" Type=\"HyperSlab\" Dimensions=\"" << joined(array.record)
          << "\">\n<DataItem Format=\"XML\" NumberType=\"Int\" Dimensions=\"3 " << rank << "\">"
          << joined(with_first(k, zeros)) << ' ' << joined(ones) << ' ' << joined(with_first(1, array.record))
          << "</DataItem>\n<DataItem Format=\"HDF\" " << array.number << " Dimensions=\""
          << joined(with_first(frames, array.record)) << "\">" << escaped(content_.archive_name) << ':'
          << array.path << "</DataItem>\n</DataItem>\n";
  }

  const XdmfContent& content_;
  std::ostringstream text_;
};

}  // namespace

std::string xdmf_document(const XdmfContent& content) {
  return Document(content).text();
}

}  // namespace rouleau::storage
