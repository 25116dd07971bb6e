/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "vtpFile.H"
#include "error.H"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <zlib.h>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

class vtpReader
{
    const fileName& file_;
    std::string text_;

    //- Where the binary part begins
    size_t binary_;

public:

    explicit vtpReader(const fileName& file)
    :
        file_(file)
    {
        std::ifstream is(file, std::ios::binary);
        std::ostringstream os;
        os << is.rdbuf();
        text_ = os.str();
        if (!is)
        {
            stop("it cannot be read");
        }
        const std::string start("<AppendedData encoding=\"raw\">\n_");
        binary_ = text_.find(start);
        if (binary_ == std::string::npos)
        {
            stop("it has no binary part");
        }
        binary_ += start.size();
    }

    void stop(const std::string& why) const
    {
        FatalErrorInFunction
            << "The file " << file_ << " is broken: " << why.c_str()
            << exit(FatalError);
    }

    //- Where the next tag of a name begins; npos if there is none
    size_t findTag(const std::string& name, const size_t from) const
    {
        const size_t k = text_.find("<" + name + " ", from);
        return k < binary_ ? k : std::string::npos;
    }

    std::string attribute(const size_t tag, const std::string& key) const
    {
        const size_t end = text_.find('>', tag);
        const std::string start(" " + key + "=\"");
        const size_t k = text_.find(start, tag);
        const size_t close = text_.find('"', k + start.size());
        if (k == std::string::npos || k > end || close > end)
        {
            stop("there is no attribute " + key);
        }
        return text_.substr(k + start.size(), close - k - start.size());
    }

    size_t number(const size_t tag, const std::string& key) const
    {
        const std::string value(attribute(tag, key));
        char* end;
        const unsigned long long n = std::strtoull(value.c_str(), &end, 10);
        if (value.empty() || *end || n > text_.size()*1100)
        {
            stop(key + " is " + value);
        }
        return n;
    }

    //- The bytes of an array that should have a size
    std::string bytes(const size_t tag, const size_t size) const
    {
        size_t i = binary_ + number(tag, "offset");
        const auto next = [&]()
        {
            uint64_t x = 0;
            if (i + sizeof(x) > text_.size())
            {
                stop("it ends too early");
            }
            std::memcpy(&x, &text_[i], sizeof(x));
            i += sizeof(x);
            return x;
        };
        const uint64_t n = next(), block = next(), rest = next();
        if
        (
            block != vtpFile::blockSize || n != (size + block - 1)/block
         || rest != size % block
        )
        {
            stop("an array has a wrong length");
        }

        std::vector<uint64_t> lengths(n);
        for (uint64_t& length : lengths)
        {
            length = next();
        }
        std::string all(size, 0);
        for (size_t b = 0; b < n; ++b)
        {
            if (lengths[b] > text_.size() || i + lengths[b] > text_.size())
            {
                stop("it ends too early");
            }
            const size_t expected = min(size_t(block), size - b*block);
            uLongf room = expected;
            const int status = uncompress
            (
                reinterpret_cast<Bytef*>(&all[b*block]),
                &room,
                reinterpret_cast<const Bytef*>(&text_[i]),
                lengths[b]
            );
            if (status != Z_OK || room != expected)
            {
                stop("a compressed block is not what was written");
            }
            i += lengths[b];
        }
        return all;
    }
};


template<class T>
std::vector<T> valuesOf(const std::string& bytes)
{
    std::vector<T> values(bytes.size()/sizeof(T));
    if (values.size())
    {
        std::memcpy(values.data(), bytes.data(), bytes.size());
    }
    return values;
}


vectorField vectorsOf(const std::string& bytes)
{
    const std::vector<double> x(valuesOf<double>(bytes));
    vectorField v(x.size()/3);
    forAll(v, i)
    {
        v[i] = vector(x[3*i], x[3*i + 1], x[3*i + 2]);
    }
    return v;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::vtpFile::array& Foam::vtpFile::find
(
    const word& name,
    const array& like
) const
{
    for (const array& a : data_)
    {
        if
        (
            a.name == name && a.type == like.type
         && a.nComponents == like.nComponents
        )
        {
            return a;
        }
    }
    FatalErrorInFunction
        << "There is no array " << name << " of " << like.nComponents << ' '
        << like.type.c_str() << " among " << names() << exit(FatalError);
    return points_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::vtpFile::vtpFile(const fileName& file)
:
    nPoints_(0)
{
    const vtpReader in(file);
    const size_t piece = in.findTag("Piece", 0);
    if (piece == std::string::npos)
    {
        in.stop("it has no Piece");
    }
    nPoints_ = in.number(piece, "NumberOfPoints");
    nTogether_ = in.number(piece, "NumberOfLines") > 0 ? 2 : 1;

    bool found = false;
    for
    (
        size_t tag = in.findTag("DataArray", piece);
        tag != std::string::npos;
        tag = in.findTag("DataArray", tag + 1)
    )
    {
        array a
        {
            in.attribute(tag, "Name"),
            in.attribute(tag, "type"),
            label(in.number(tag, "NumberOfComponents")),
            ""
        };
        if
        (
            (a.type != "Float64" && a.type != "Int64")
         || (a.nComponents != 1 && a.nComponents != 3)
        )
        {
            in.stop("the array " + a.name + " is of an unknown kind");
        }
        const label n = a.name == "offsets" ? nPoints_/nTogether_ : nPoints_;
        a.bytes = in.bytes(tag, 8*a.nComponents*n);
        if (a.name == "Points" && a.nComponents == 3)
        {
            points_ = a;
            found = true;
        }
        else if (a.name != "connectivity" && a.name != "offsets")
        {
            data_.push_back(a);
        }
    }
    if (!found)
    {
        in.stop("it has no points");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::vtpFile::names() const
{
    wordList all;
    for (const array& a : data_)
    {
        all.append(word(a.name));
    }
    return all;
}


Foam::pointField Foam::vtpFile::points() const
{
    return vectorsOf(points_.bytes);
}


Foam::scalarField Foam::vtpFile::scalars(const word& name) const
{
    const std::vector<double> x
    (
        valuesOf<double>(find(name, array{"", "Float64", 1, ""}).bytes)
    );
    scalarField values(x.size());
    std::copy(x.begin(), x.end(), values.begin());
    return values;
}


Foam::vectorField Foam::vtpFile::vectors(const word& name) const
{
    return vectorsOf(find(name, array{"", "Float64", 3, ""}).bytes);
}


Foam::labelList Foam::vtpFile::labels(const word& name) const
{
    const std::vector<int64_t> x
    (
        valuesOf<int64_t>(find(name, array{"", "Int64", 1, ""}).bytes)
    );
    labelList values(x.size());
    std::copy(x.begin(), x.end(), values.begin());
    return values;
}


// ************************************************************************* //
