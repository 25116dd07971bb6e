/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "dictionaryText.H"
#include "error.H"
#include "label.H"

#include <cctype>
#include <cfenv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using Foam::label;

class reader
{
    const Foam::fileName& file_;
    std::string text_;
    size_t i_ = 0;
    label line_ = 1;

    //- An open bracket: its kind and line; of a dictionary the keywords
    struct bracket
    {
        char kind;
        label line;
        std::map<std::string, label> keys;
        bool isHead;
    };
    std::vector<bracket> open_;

    //- Words of the statement so far, and the line of its first
    std::string key_;
    label keyLine_ = 0;
    label nWords_ = 0;

    bool conditional_ = false;


    [[noreturn]] void stop(const std::string& what, const label line) const
    {
        Foam::FatalIOError
        (
            FUNCTION_NAME, __FILE__, __LINE__, file_, line
        )   << what.c_str() << exit(Foam::FatalIOError);
        std::abort();
    }

    static std::string inLine(const label line)
    {
        return " in line " + std::to_string(line);
    }

    bool at(const char* s) const
    {
        return text_.compare(i_, std::strlen(s), s) == 0;
    }

    void step()
    {
        line_ += text_[i_] == '\n';
        ++i_;
    }

    //- Go behind the next end of what was opened here
    void skipTo(const char* end, const char* what)
    {
        const label line = line_;
        while (i_ < text_.size() && !at(end))
        {
            step();
        }
        if (i_ >= text_.size())
        {
            stop("The " + std::string(what) + " has no end", line);
        }
        i_ += std::strlen(end);
    }

    void skipString()
    {
        const label line = line_;
        for (step(); i_ < text_.size() && text_[i_] != '"'; step())
        {
            if (text_[i_] == '\\' && i_ + 1 < text_.size())
            {
                step();
            }
        }
        if (i_ >= text_.size())
        {
            stop("The string has no end", line);
        }
        step();
    }

    bool inDictionary() const
    {
        return open_.back().kind == '{';
    }

    void endStatement()
    {
        key_.clear();
        nWords_ = 0;
    }

    //- A number that overflows ends OpenFOAM's reader by a signal
    void checkNumber(const std::string& text) const
    {
        if (!std::strchr("+-.0123456789", text[0]))
        {
            return;
        }
        std::fenv_t traps;
        std::feholdexcept(&traps);
        const double value = std::strtod(text.c_str(), nullptr);
        std::fesetenv(&traps);
        if (std::isinf(value))
        {
            stop("The number " + text + " is too large", line_);
        }
    }

    //- OpenFOAM makes a number of this one without looking at its size
    void checkVersion(const std::string& value) const
    {
        char* end;
        const double version = std::strtod(value.c_str(), &end);
        if (*end || !(version > 0 && version < 100))
        {
            stop("The version '" + value + "' of the head is none", line_);
        }
    }

    //- The statement has a keyword: is it new in this dictionary?
    void note()
    {
        if (key_.empty() || !inDictionary() || conditional_)
        {
            return;
        }
        const auto old = open_.back().keys.emplace(key_, keyLine_);
        if (!old.second)
        {
            stop
            (
                "The keyword '" + key_ + "' stands twice in one dictionary,"
              + inLine(old.first->second) + " and" + inLine(keyLine_),
                keyLine_
            );
        }
    }

    void word()
    {
        const size_t start = i_;
        const label line = line_;
        if (text_[i_] == '"')
        {
            skipString();
        }
        else
        {
            while
            (
                i_ < text_.size() && !std::isspace((unsigned char)text_[i_])
             && !std::strchr("{}();\"", text_[i_])
             && !at("//") && !at("/*")
            )
            {
                step();
            }
        }
        checkNumber(text_.substr(start, i_ - start));
        if (nWords_++ || !inDictionary())
        {
            if (nWords_ == 2 && key_ == "version" && open_.back().isHead)
            {
                checkVersion(text_.substr(start, i_ - start));
            }
            return;
        }

        key_ = text_.substr(start, i_ - start);
        keyLine_ = line;
        if (key_[0] == '#')
        {
            // A directive ends with its line
            conditional_ = conditional_ || key_.compare(1, 2, "if") == 0;
            while (i_ < text_.size() && text_[i_] != '\n')
            {
                step();
            }
            endStatement();
        }
        else if (key_[0] == '$')
        {
            key_.clear();
        }
    }

    void close(const char kind)
    {
        const char opening = kind == '}' ? '{' : '(';
        if (open_.size() < 2)
        {
            stop(std::string("There is no '") + opening + "' for this '"
              + kind + "'", line_);
        }
        if (open_.back().kind != opening)
        {
            stop(std::string("The '") + open_.back().kind + "'"
              + inLine(open_.back().line) + " ends with '" + kind + "'", line_);
        }
        open_.pop_back();
        if (kind == '}' && inDictionary())
        {
            endStatement();
        }
    }

    void punctuation()
    {
        const char c = text_[i_];
        if (c == '{' || c == '(')
        {
            if (c == '{')
            {
                note();
            }
            open_.push_back
            (
                bracket{c, line_, {}, open_.size() == 1 && key_ == "FoamFile"}
            );
            if (c == '{')
            {
                endStatement();
            }
        }
        else if (c == ';')
        {
            note();
            endStatement();
        }
        else
        {
            close(c);
        }
        step();
    }


public:

    explicit reader(const Foam::fileName& file)
    :
        file_(file)
    {
        std::ifstream is(file);
        std::ostringstream os;
        os << is.rdbuf();
        text_ = os.str();
        open_.push_back(bracket{'{', 1, {}, false});
    }

    void operator()()
    {
        while (i_ < text_.size())
        {
            const char c = text_[i_];
            if (std::isspace((unsigned char)c))
            {
                step();
            }
            else if (c == '\0')
            {
                stop("There is a byte 0: this is no text", line_);
            }
            else if (at("//"))
            {
                while (i_ < text_.size() && text_[i_] != '\n')
                {
                    step();
                }
            }
            else if (at("/*"))
            {
                skipTo("*/", "comment");
            }
            else if (at("#{"))
            {
                skipTo("#}", "text #{");
            }
            else if (std::strchr("{}();", c))
            {
                punctuation();
            }
            else
            {
                word();
            }
        }
        if (open_.size() > 1)
        {
            stop(std::string("There is no end for the '") + open_.back().kind
              + "'" + inLine(open_.back().line), open_.back().line);
        }
        if (nWords_)
        {
            stop("There is no ';' after '" + key_ + "'", keyLine_);
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

void Foam::dem::checkText(const fileName& file)
{
    reader r(file);
    r();
}


// ************************************************************************* //
