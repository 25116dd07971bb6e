/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "savedFile.H"
#include "error.H"
#include "OSspecific.H"
#include "StringStream.H"
#include "vector.H"

#include <cctype>
#include <cfenv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>
#include <zlib.h>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

class savedFile
{
    const fileName& file_;
    const size_t most_;
    std::string text_;

    //- Where the reader is
    size_t i_ = 0;

    //- Of the head
    std::string class_, format_;


    void stop(const std::string& what) const
    {
        FatalIOError(FUNCTION_NAME, __FILE__, __LINE__, file_)
            << what.c_str() << exit(FatalIOError);
    }

    void read()
    {
        const fileName zipped(file_ + ".gz");
        gzFile in = gzopen
        (
            (isFile(file_, false) ? file_ : zipped).c_str(),
            "rb"
        );
        if (!in)
        {
            stop("The file cannot be opened.");
        }
        std::vector<char> part(1 << 16);
        int n;
        while ((n = gzread(in, part.data(), part.size())) > 0)
        {
            text_.append(part.data(), n);
        }
        gzclose(in);
        if (n < 0)
        {
            stop("The compressed file is broken.");
        }
    }

    //- The value of a key of the head, without quotation marks
    static std::string valueOf(const std::string& head, const std::string& key)
    {
        const size_t k = head.find(key);
        if (k == std::string::npos)
        {
            return "";
        }
        const size_t start = head.find_first_not_of(" \t", k + key.size());
        if (start == std::string::npos)
        {
            return "";
        }
        const bool quoted = head[start] == '"';
        const size_t first = start + quoted;
        const size_t end = head.find_first_of(quoted ? "\"" : " \t;", first);
        return head.substr(first, end - first);
    }

    void readHead()
    {
        const size_t start = text_.find("FoamFile");
        const size_t end = text_.find('}');
        if (start > 4096 || end > 4096 || start > end)
        {
            stop("The file has no head.");
        }
        const std::string head(text_.substr(start, end - start));
        class_ = valueOf(head, "class");
        format_ = valueOf(head, "format");

        if (valueOf(head, "version") != "2.0")
        {
            stop("The version in the head is not 2.0.");
        }
        if (format_ != "ascii" && format_ != "binary")
        {
            stop("The format in the head is neither ascii nor binary.");
        }
        const std::string arch(valueOf(head, "arch"));
        const std::string own
        (
            "label=" + std::to_string(8*sizeof(label))
          + ";scalar=" + std::to_string(8*sizeof(scalar))
        );
        if (arch.size() && arch.find(own) == std::string::npos)
        {
            stop("The file was not written with " + own + '.');
        }

        // Behind the head and the line of stars
        i_ = end + 1;
        skipBlanks();
        while (text_.compare(i_, 2, "//") == 0)
        {
            i_ = min(text_.find('\n', i_), text_.size());
            skipBlanks();
        }
    }

    void skipBlanks()
    {
        while (i_ < text_.size() && std::isspace((unsigned char)text_[i_]))
        {
            ++i_;
        }
    }

    size_t readCount(const size_t most)
    {
        skipBlanks();
        const size_t start = i_;
        while (i_ < text_.size() && std::isdigit((unsigned char)text_[i_]))
        {
            ++i_;
        }
        const std::string digits(text_.substr(start, i_ - start));
        const double n = std::strtod(digits.c_str(), nullptr);
        if (digits.empty() || !(n <= double(most)))
        {
            stop("The number of entries, '" + digits + "', cannot be.");
        }
        return size_t(n);
    }

    //- Go over n entries in binary; returns where they start
    const char* readBytes(const size_t n, const size_t size)
    {
        skipBlanks();
        const size_t end = i_ + 1 + n*size;
        if
        (
            end >= text_.size() || text_[i_] != '(' || text_[end] != ')'
        )
        {
            stop("There are not " + std::to_string(n) + " entries of "
              + std::to_string(size) + " bytes.");
        }
        const char* start = &text_[i_ + 1];
        i_ = end + 1;
        return start;
    }

    void checkBinary()
    {
        const bool lists = class_.find("Compact") != std::string::npos;
        const size_t size =
            class_.compare(0, 5, "label") == 0 ? sizeof(label)
          : class_.compare(0, 6, "scalar") == 0 ? sizeof(scalar)
          : class_.compare(0, 6, "vector") == 0 ? sizeof(vector)
          : 0;
        if (!size)
        {
            stop("The class in the head, '" + class_ + "', is not known.");
        }
        const size_t n = readCount(most_ + 1);
        if (!lists)
        {
            if (n)
            {
                readBytes(n, size);
            }
            return;
        }

        // Offsets of the lists in all their entries, then these
        if (!n)
        {
            stop("The lists have no offsets.");
        }
        const char* bytes = readBytes(n, sizeof(label));
        List<label> offsets(n);
        std::memcpy(offsets.begin(), bytes, n*sizeof(label));
        const size_t m = readCount(text_.size());
        bool good = offsets[0] == 0 && size_t(offsets.last()) == m;
        for (label k = 1; k < offsets.size(); ++k)
        {
            good = good && offsets[k] >= offsets[k - 1];
        }
        if (!good)
        {
            stop("The offsets of the lists do not fit their entries.");
        }
        if (m)
        {
            readBytes(m, size);
        }
    }

    //- A number that overflows ends OpenFOAM's reader by a signal
    void checkNumbers() const
    {
        std::fenv_t traps;
        std::feholdexcept(&traps);
        bool overflow = false;
        const char* const separators = " \t\r\n(){};";
        for
        (
            size_t k = text_.find_first_not_of(separators, i_);
            k != std::string::npos;
            k = text_.find_first_not_of
            (
                separators,
                min(text_.find_first_of(separators, k), text_.size())
            )
        )
        {
            overflow =
                overflow
             || std::isinf(std::strtod(text_.c_str() + k, nullptr));
        }
        std::fesetenv(&traps);
        if (overflow)
        {
            stop("There is a number that is too large.");
        }
    }

    //- Each number before a bracket says how many follow
    void checkText()
    {
        checkNumbers();
        readCount(most_);
        const size_t most = max(most_, text_.size());
        for (size_t k = i_; k < text_.size(); ++k)
        {
            if (text_[k] != '(' && text_[k] != '{')
            {
                continue;
            }
            size_t first = k;
            while (first && std::isdigit((unsigned char)text_[first - 1]))
            {
                --first;
            }
            const double n =
                std::strtod(text_.substr(first, k - first).c_str(), nullptr);
            if (!(n <= double(most)))
            {
                stop("The number of entries, "
                  + text_.substr(first, k - first) + ", cannot be.");
            }
        }
    }


public:

    savedFile(const fileName& file, const label most)
    :
        file_(file),
        most_(max(most, label(0)))
    {
        read();
        readHead();
        format_ == "binary" ? checkBinary() : checkText();
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

void Foam::cloudState::checkSavedFile(const fileName& file, const label most)
{
    savedFile(file, most);
}


Foam::label Foam::cloudState::textChecksum(const dictionary& dict)
{
    dictionary rest(dict);
    rest.remove("checksum");
    rest.remove("checksums");

    OStringStream os;
    os.precision(17);
    rest.write(os, false);

    std::string text;
    for (const char c : os.str())
    {
        if (!std::isspace((unsigned char)c))
        {
            text += c;
        }
    }
    const uLong crc = ::crc32
    (
        0,
        reinterpret_cast<const Bytef*>(text.data()),
        text.size()
    );
    return label(crc & 0x7fffffff);
}


// ************************************************************************* //
