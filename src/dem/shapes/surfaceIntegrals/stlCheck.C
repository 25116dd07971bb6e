/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "stlCheck.H"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The form of an STL text, line by line:
//      solid ... { facet normal n  outer loop  3 vertices  endloop endfacet }
//      endsolid ...
class stlText
{
    std::istringstream lines_;
    int line_ = 0;

    //- Words of the present line, in small letters
    std::vector<std::string> words_;

    //- Go to the next line that is not empty; false at the end
    bool next()
    {
        std::string line;
        while (std::getline(lines_, line))
        {
            ++line_;
            words_.clear();
            std::istringstream is(line);
            for (std::string w; is >> w;)
            {
                std::transform(w.begin(), w.end(), w.begin(), ::tolower);
                words_.push_back(w);
            }
            if (words_.size())
            {
                return true;
            }
        }
        return false;
    }

    //- Is the line these words and n numbers?
    bool is(const std::vector<std::string>& words, const size_t n) const
    {
        const size_t first = words.size();
        if
        (
            words_.size() != first + n
         || !std::equal(words.begin(), words.end(), words_.begin())
        )
        {
            return false;
        }
        return std::all_of
        (
            words_.begin() + first,
            words_.end(),
            [](const std::string& w)
            {
                char* end;
                std::strtod(w.c_str(), &end);
                return !*end;
            }
        );
    }

    std::string unexpected(const std::string& expected) const
    {
        return
            "line " + std::to_string(line_) + " is not '" + expected + "'";
    }


public:

    explicit stlText(const std::string& text)
    :
        lines_(text)
    {}

    std::string complaint()
    {
        while (next())
        {
            if (words_[0] != "solid")
            {
                return unexpected("solid NAME");
            }
            for (bool more = true; more;)
            {
                if (!next())
                {
                    return "it ends without 'endsolid'";
                }
                if (words_[0] == "endsolid")
                {
                    more = false;
                    continue;
                }
                if (!is({"facet", "normal"}, 3))
                {
                    return unexpected("facet normal X Y Z");
                }
                if (!next() || !is({"outer", "loop"}, 0))
                {
                    return unexpected("outer loop");
                }
                for (int corner = 0; corner < 3; ++corner)
                {
                    if (!next() || !is({"vertex"}, 3))
                    {
                        return unexpected("vertex X Y Z");
                    }
                }
                if (!next() || !is({"endloop"}, 0))
                {
                    return unexpected("endloop");
                }
                if (!next() || !is({"endfacet"}, 0))
                {
                    return unexpected("endfacet");
                }
            }
        }
        return "";
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::string Foam::dem::checkSTL(const fileName& file)
{
    std::ifstream is(file, std::ios::binary);
    std::ostringstream os;
    os << is.rdbuf();
    const std::string content(os.str());

    const size_t first = content.find_first_not_of(" \t\r\n");
    std::string start(content.substr(std::min(first, content.size()), 5));
    std::transform(start.begin(), start.end(), start.begin(), ::tolower);

    if (start == "solid")
    {
        const auto odd = std::find_if
        (
            content.begin(),
            content.end(),
            [](const unsigned char c)
            {
                return !c || (c < ' ' && !std::isspace(c));
            }
        );
        if (odd != content.end())
        {
            return
                "it starts with 'solid' like a text, but byte "
              + std::to_string(odd - content.begin()) + " is none";
        }
        return stlText(content).complaint();
    }

    // 80 bytes, the number of triangles, 50 bytes for each
    uint32_t n = 0;
    if (content.size() >= 84)
    {
        std::memcpy(&n, content.data() + 80, sizeof(n));
    }
    if (content.size() < 84 || content.size() != 84 + 50*size_t(n))
    {
        return
            "it does not start with 'solid' like a text, and as a binary file"
            " of " + std::to_string(n) + " triangles it would have "
          + std::to_string(84 + 50*size_t(n)) + " bytes, not "
          + std::to_string(content.size());
    }
    return "";
}


// ************************************************************************* //
