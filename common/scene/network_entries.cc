// SPDX-License-Identifier: LGPL-2.1-or-later
// Section Network: nodes, springs, bars and bonds without a mesh.
#include "scene/network_entries.h"

#include "base/parameter_error.h"

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    using Words = std::vector<std::string>;

    /// The items of a list, in words; an empty list has none.
    std::vector<Words> items_of(const std::string &list)
    {
      std::vector<Words> items;
      for (const std::string &item : Utilities::split_string_list(list, ','))
        {
          std::istringstream in(item);
          Words              words;
          for (std::string word; in >> word;)
            words.push_back(word);
          if (!words.empty())
            items.push_back(words);
        }
      return items;
    }

    /// Reads the items of one entry.
    struct Reader
    {
      std::string                     path;
      const std::vector<std::string> &names; ///< of the nodes

      void needs(const Words       &item,
                 const unsigned int n,
                 const std::string &form) const
      {
        std::string typed;
        for (const std::string &word : item)
          typed += (typed.empty() ? "" : " ") + word;
        if (item.size() != n)
          throw ExcParameter(path,
                             "needs " + std::to_string(n) + " words, " + form +
                               "; got " + std::to_string(item.size()) +
                               " in \"" + typed + "\".");
      }

      unsigned int node(const std::string &name) const
      {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end())
          throw ExcParameter(path,
                             "must name a node of Network/nodes; got \"" +
                               name + "\".");
        return found - names.begin();
      }

      double number(const std::string &word) const
      {
        char        *end   = nullptr;
        const double value = std::strtod(word.c_str(), &end);
        if (*end != '\0' || end == word.c_str())
          throw ExcParameter(path, "needs a number; got \"" + word + "\".");
        return value;
      }

      double positive(const std::string &word) const
      {
        const double value = number(word);
        if (!(value > 0.))
          throw ExcParameter(path, "must exceed 0; got " + word + ".");
        return value;
      }

      unsigned int direction(const char c) const
      {
        if (c != 'x' && c != 'y')
          throw ExcParameter(path,
                             std::string("knows the components x, y; got \"") +
                               c + "\".");
        return c - 'x';
      }

      /// "bar xy", or "-bar y" for the opposite direction.
      std::vector<Network::Component> components(const std::string &list) const
      {
        std::vector<Network::Component> result;
        for (const Words &item : items_of(list))
          {
            needs(item, 2, "a node and its components, such as bar xy");
            const bool turned = item[0][0] == '-';
            for (const char c : item[1])
              result.push_back({node(turned ? item[0].substr(1) : item[0]),
                                direction(c),
                                turned ? -1. : 1.});
          }
        return result;
      }

      std::vector<Network::LinkEntry> links(const std::string &list,
                                            const std::string &size) const
      {
        std::vector<Network::LinkEntry> result;
        for (const Words &item : items_of(list))
          {
            needs(item, 3, "two nodes and " + size);
            result.push_back({node(item[0]), node(item[1]), positive(item[2])});
          }
        return result;
      }
    };
  } // namespace

  std::map<unsigned int, unsigned int> Network::unknowns() const
  {
    std::map<unsigned int, unsigned int> numbers;
    for (const SpringEntry &s : springs)
      for (const unsigned int node : {s.a, s.b})
        numbers[2 * node + s.direction] = 0;
    for (const auto *list : {&bars, &bonds})
      for (const LinkEntry &link : *list)
        for (const unsigned int node : {link.a, link.b})
          for (const unsigned int d : {0, 1})
            numbers[2 * node + d] = 0;
    unsigned int next = 0;
    for (auto &number : numbers)
      number.second = next++;
    return numbers;
  }

  void NetworkEntries::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Network");
    prm.add_parameter("nodes", nodes, "list of name, X and Y [mm]");
    prm.add_parameter("held", held, "nodes and components at rest");
    prm.add_parameter("driven",
                      driven,
                      "nodes and components that follow the motion");
    prm.add_parameter("motion", motion, "of driven ones, formula in t [mm]");
    prm.add_parameter("loaded", loaded, "nodes and components with the load");
    prm.add_parameter("load", load, "formula in t [N]");
    prm.add_parameter("springs",
                      springs,
                      "list of two nodes, component and stiffness [N/mm]");
    prm.add_parameter("bars", bars, "list of two nodes and EA [N]");
    prm.add_parameter("bonds",
                      bonds,
                      "list of two nodes and area [mm^2]; the law is that of "
                      "section Adhesion, its normal +y");
    prm.add_parameter("opening of",
                      opening,
                      "node and component whose travel is the opening and "
                      "whose force is measured; -node: against the axis");
    prm.add_parameter("end time",
                      end_time,
                      "of the process [s]",
                      Patterns::Double(1e-12));
    prm.leave_subsection();
  }

  Network NetworkEntries::network() const
  {
    Network                  network;
    std::vector<std::string> names;
    Reader                   reader{"Network/nodes", names};
    for (const Words &item : items_of(nodes))
      {
        reader.needs(item, 3, "a name, X and Y");
        names.push_back(item[0]);
        network.nodes.emplace_back(reader.number(item[1]),
                                   reader.number(item[2]));
      }
    if (names.empty())
      throw ExcParameter("Network/nodes",
                         "must name at least one node; got none.");
    const auto read = [&](const std::string &entry) {
      return Reader{"Network/" + entry, names};
    };
    network.held    = read("held").components(held);
    network.driven  = read("driven").components(driven);
    network.loaded  = read("loaded").components(loaded);
    network.opening = read("opening of").components(opening);
    network.bars    = read("bars").links(bars, "EA [N]");
    network.bonds   = read("bonds").links(bonds, "an area [mm^2]");
    reader.path     = "Network/springs";
    for (const Words &item : items_of(springs))
      {
        reader.needs(item, 4, "two nodes, a component and a stiffness");
        network.springs.push_back({reader.node(item[0]),
                                   reader.node(item[1]),
                                   reader.direction(item[2][0]),
                                   reader.positive(item[3])});
      }
    const auto unknowns = network.unknowns();
    for (const auto *list : {&network.loaded, &network.opening})
      for (const auto &c : *list)
        if (unknowns.count(2 * c.node + c.direction) == 0)
          throw ExcParameter(
            list == &network.loaded ? "Network/loaded" : "Network/opening of",
            "must name what a spring, bar or bond holds; got " + names[c.node] +
              " " + "xy"[c.direction] + ".");
    if (network.opening.size() != 1)
      throw ExcParameter("Network/opening of",
                         "must name one node and one component; got " +
                           std::to_string(network.opening.size()) + ".");
    return network;
  }
} // namespace demold
