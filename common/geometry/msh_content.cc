// SPDX-License-Identifier: LGPL-2.1-or-later
// A reader of ASCII .msh files that trusts nothing.
#include "geometry/msh_content.h"

#include <cmath>
#include <fstream>
#include <map>
#include <utility>

#include "base/parameter_error.h"

namespace demold
{
  using namespace dealii;

  namespace
  {
    struct TypeFacts
    {
      const char  *name;
      unsigned int n_nodes;
    };

    const std::map<unsigned int, TypeFacts> &element_types()
    {
      static const std::map<unsigned int, TypeFacts> types = {
        {1, {"line", 2}},
        {2, {"triangle", 3}},
        {3, {"quadrilateral", 4}},
        {4, {"tetrahedron", 4}},
        {5, {"hexahedron", 8}},
        {6, {"prism", 6}},
        {7, {"pyramid", 5}},
        {8, {"line of second order", 3}},
        {9, {"triangle of second order", 6}},
        {10, {"quadrilateral of second order", 9}},
        {11, {"tetrahedron of second order", 10}},
        {12, {"hexahedron of second order", 27}},
        {13, {"prism of second order", 18}},
        {14, {"pyramid of second order", 14}},
        {15, {"point", 1}},
        {16, {"quadrilateral of second order", 8}},
        {17, {"hexahedron of second order", 20}},
        {18, {"prism of second order", 15}},
        {19, {"pyramid of second order", 13}}};
      return types;
    }

    class MshReader
    {
    public:
      MshReader(const std::string &file, const std::string &path)
        : file(file)
        , path(path)
        , in(file)
      {
        if (!in)
          fail("cannot be opened. The path is relative to the folder the "
               "program is started in.");
      }

      MshContent read()
      {
        std::string section;
        while (in >> section)
          {
            if (section == "$MeshFormat")
              read_format();
            else if (section == "$Entities" && version >= 4)
              read_entities();
            else if (section == "$Nodes")
              version < 4 ? read_nodes_2() : read_nodes_4();
            else if (section == "$Elements")
              version < 4 ? read_elements_2() : read_elements_4();
            else if (section[0] == '$')
              {
                skip_to_end_of(section);
                continue;
              }
            else
              fail("has '" + section +
                   "' where a section such as $Nodes should begin.");
            expect("$End" + section.substr(1));
          }
        if (content.points.empty())
          fail("has no section $Nodes with nodes in it.");
        if (content.elements.empty())
          fail("has no section $Elements with elements in it.");
        return std::move(content);
      }

    private:
      [[noreturn]] void fail(const std::string &what) const
      {
        throw ExcParameter(path, "the file '" + file + "' " + what);
      }

      template <typename T>
      T next(const std::string &what)
      {
        T value{};
        if (!(in >> value))
          fail("is broken or cut off where " + what + " should stand.");
        return value;
      }

      void expect(const std::string &word)
      {
        const auto found = next<std::string>(word);
        if (found != word)
          fail("has '" + found + "' where " + word +
               " should stand: more or fewer entries than announced.");
      }

      void skip_to_end_of(const std::string &section)
      {
        const std::string end = "$End" + section.substr(1);
        std::string       word;
        while (in >> word)
          if (word == end)
            return;
        fail("ends inside the section " + section + ".");
      }

      void read_format()
      {
        version           = next<double>("the version");
        const int is_text = next<int>("the file type") == 0;
        next<int>("the size of numbers");
        if (!is_text)
          fail("is binary; only ASCII files are read. In Gmsh set "
               "Mesh.Binary = 0.");
        if (!((version >= 2 && version < 3) || std::abs(version - 4.1) < 1e-9))
          fail("has format " + std::to_string(version) +
               "; formats 2.2 and 4.1 are read. In Gmsh set "
               "Mesh.MshFileVersion = 4.1.");
      }

      void read_entities()
      {
        int count[4];
        for (int &n : count)
          n = next<int>("a number of entities");
        for (int dim = 0; dim < 4; ++dim)
          for (int i = 0; i < count[dim]; ++i)
            {
              const int tag = next<int>("an entity");
              for (int k = 0; k < (dim == 0 ? 3 : 6); ++k)
                next<double>("a coordinate of an entity");
              const int n_groups = next<int>("a number of physical groups");
              for (int k = 0; k < n_groups; ++k)
                {
                  const int group = next<int>("a physical group");
                  physical_of.emplace(std::make_pair(dim, tag), group);
                }
              const int n_bounds =
                dim == 0 ? 0 : next<int>("a number of bounding entities");
              for (int k = 0; k < n_bounds; ++k)
                next<int>("a bounding entity");
            }
      }

      void add_point(const unsigned long number)
      {
        Point<3> p;
        for (unsigned int d = 0; d < 3; ++d)
          p[d] = next<double>("a coordinate of node " + std::to_string(number));
        if (!(p.norm() < 1e100))
          fail("has a node " + std::to_string(number) + " at infinity.");
        if (!index_of.emplace(number, content.points.size()).second)
          fail("has two nodes with number " + std::to_string(number) + ".");
        content.points.push_back(p);
      }

      void read_nodes_2()
      {
        const auto n = next<unsigned long>("the number of nodes");
        for (unsigned long i = 0; i < n; ++i)
          add_point(next<unsigned long>("a node"));
      }

      void read_nodes_4()
      {
        const auto n_blocks = next<unsigned long>("a number of node blocks");
        for (unsigned int k = 0; k < 3; ++k)
          next<unsigned long>("the number of nodes");
        for (unsigned long b = 0; b < n_blocks; ++b)
          {
            next<int>("a dimension");
            next<int>("an entity");
            if (next<int>("0 or 1 for parametric nodes") != 0)
              fail("has parametric nodes, which are not read. In Gmsh set "
                   "Mesh.SaveParametric = 0.");
            const auto n = next<unsigned long>("a number of nodes");
            std::vector<unsigned long> numbers;
            for (unsigned long i = 0; i < n; ++i)
              numbers.push_back(next<unsigned long>("a node number"));
            for (const unsigned long number : numbers)
              add_point(number);
          }
      }

      void add_element(const unsigned int number,
                       const unsigned int type,
                       const int          physical)
      {
        const auto facts = element_types().find(type);
        if (facts == element_types().end())
          fail("has an element " + std::to_string(number) + " of type " +
               std::to_string(type) + ", which is not known here.");
        MshElement element{number, type, physical, {}};
        for (unsigned int i = 0; i < facts->second.n_nodes; ++i)
          {
            const auto node  = next<unsigned long>("a node of element " +
                                                  std::to_string(number));
            const auto entry = index_of.find(node);
            if (entry == index_of.end())
              fail("has an element " + std::to_string(number) + " with node " +
                   std::to_string(node) + ", which does not exist.");
            element.nodes.push_back(entry->second);
          }
        content.elements.push_back(std::move(element));
      }

      void read_elements_2()
      {
        const auto n = next<unsigned long>("the number of elements");
        for (unsigned long i = 0; i < n; ++i)
          {
            const auto number   = next<unsigned int>("an element");
            const auto type     = next<unsigned int>("an element type");
            const auto n_tags   = next<unsigned int>("a number of tags");
            int        physical = 0;
            for (unsigned int k = 0; k < n_tags; ++k)
              {
                const int tag = next<int>("a tag");
                if (k == 0)
                  physical = tag;
              }
            add_element(number, type, physical);
          }
      }

      void read_elements_4()
      {
        const auto n_blocks = next<unsigned long>("a number of blocks");
        for (unsigned int k = 0; k < 3; ++k)
          next<unsigned long>("the number of elements");
        for (unsigned long b = 0; b < n_blocks; ++b)
          {
            const int  dim    = next<int>("a dimension");
            const int  entity = next<int>("an entity");
            const auto type   = next<unsigned int>("an element type");
            const auto n      = next<unsigned long>("a number of elements");
            const auto group  = physical_of.find({dim, entity});
            for (unsigned long i = 0; i < n; ++i)
              add_element(next<unsigned int>("an element"),
                          type,
                          group == physical_of.end() ? 0 : group->second);
          }
      }

      std::string                           file, path;
      std::ifstream                         in;
      double                                version = 0;
      MshContent                            content;
      std::map<unsigned long, unsigned int> index_of;
      std::map<std::pair<int, int>, int>    physical_of;
    };
  } // namespace

  MshContent read_msh_content(const std::string &file, const std::string &path)
  {
    return MshReader(file, path).read();
  }

  std::string msh_type_name(const unsigned int type)
  {
    const auto facts = element_types().find(type);
    return facts == element_types().end() ? "type " + std::to_string(type) :
                                            facts->second.name;
  }
} // namespace demold
