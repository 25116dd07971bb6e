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
#include "instantList.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "ListOps.H"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <zlib.h>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using Foam::label;

template<class T>
std::string bytesOf(const T* first, const size_t n)
{
    return std::string(reinterpret_cast<const char*>(first), n*sizeof(T));
}


//- The numbers that VTK puts before compressed blocks, and the blocks
std::string compressed(const std::string& bytes)
{
    const size_t size = Foam::vtpFile::blockSize;
    const size_t n = (bytes.size() + size - 1)/size;
    std::vector<uint64_t> head{n, size, bytes.size() % size};
    std::string blocks;

    for (size_t b = 0; b < n; ++b)
    {
        const size_t length = std::min(size, bytes.size() - b*size);
        uLongf room = compressBound(length);
        std::string block(room, 0);
        compress2
        (
            reinterpret_cast<Bytef*>(&block[0]),
            &room,
            reinterpret_cast<const Bytef*>(&bytes[b*size]),
            length,
            Z_DEFAULT_COMPRESSION
        );
        head.push_back(room);
        blocks.append(block, 0, room);
    }
    return bytesOf(head.data(), head.size()) + blocks;
}


//- Write a file whole or not at all
void saveText(const Foam::fileName& file, const std::string& text)
{
    const Foam::fileName part(file + ".part");
    Foam::mkDir(file.path());
    {
        std::ofstream os(part, std::ios::binary);
        os.write(text.data(), text.size());
        os.close();
        if (!os)
        {
            FatalErrorInFunction
                << "Cannot write " << part << exit(Foam::FatalError);
        }
    }
    Foam::mv(part, file);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vtpFile::array Foam::vtpFile::fromScalars
(
    const word& name,
    const UList<scalar>& v
)
{
    std::vector<double> all(v.begin(), v.end());
    return array{name, "Float64", 1, bytesOf(all.data(), all.size())};
}


Foam::vtpFile::array Foam::vtpFile::fromVectors
(
    const word& name,
    const UList<vector>& v
)
{
    std::vector<double> all;
    all.reserve(3*v.size());
    for (const vector& x : v)
    {
        all.insert(all.end(), {x.x(), x.y(), x.z()});
    }
    return array{name, "Float64", 3, bytesOf(all.data(), all.size())};
}


Foam::vtpFile::array Foam::vtpFile::fromLabels
(
    const word& name,
    const UList<label>& v
)
{
    std::vector<int64_t> all(v.begin(), v.end());
    return array{name, "Int64", 1, bytesOf(all.data(), all.size())};
}


void Foam::vtpFile::add(const array& a)
{
    // All three types have eight bytes
    if (label(a.bytes.size()) != 8*a.nComponents*nPoints_)
    {
        FatalErrorInFunction
            << a.name.c_str() << " has not one value for each of the "
            << nPoints_ << " points" << exit(FatalError);
    }
    data_.push_back(a);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::vtpFile::vtpFile(const UList<point>& points, const bool lines)
:
    nPoints_(points.size()),
    nTogether_(lines ? 2 : 1),
    points_(fromVectors("Points", points))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::vtpFile::save(const fileName& file) const
{
    std::string appended;
    const auto entry = [&](const array& a)
    {
        const size_t offset = appended.size();
        appended += compressed(a.bytes);
        return
            "<DataArray type=\"" + a.type + "\" Name=\"" + a.name
          + "\" NumberOfComponents=\"" + std::to_string(a.nComponents)
          + "\" format=\"appended\" offset=\"" + std::to_string(offset)
          + "\"/>\n";
    };
    const label nCells = nPoints_/nTogether_;
    const bool lines = nTogether_ == 2;
    const std::string n(std::to_string(nCells));

    std::string xml
    (
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"PolyData\" version=\"1.0\""
        " byte_order=\"LittleEndian\" header_type=\"UInt64\""
        " compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n"
        "<Piece NumberOfPoints=\"" + std::to_string(nPoints_)
      + "\" NumberOfVerts=\"" + (lines ? "0" : n)
      + "\" NumberOfLines=\"" + (lines ? n : "0")
      + "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n"
        "<PointData>\n"
    );
    for (const array& a : data_)
    {
        xml += entry(a);
    }
    xml += "</PointData>\n<Points>\n" + entry(points_);

    // Each point is a vertex, or each two are a line
    labelList end(nCells);
    forAll(end, i)
    {
        end[i] = nTogether_*(i + 1);
    }
    const std::string kind(lines ? "Lines" : "Verts");
    xml += "</Points>\n<" + kind + ">\n";
    xml += entry(fromLabels("connectivity", identity(nPoints_)));
    xml += entry(fromLabels("offsets", end));
    xml += "</" + kind + ">\n</Piece>\n</PolyData>\n";

    saveText
    (
        file,
        xml + "<AppendedData encoding=\"raw\">\n_" + appended
      + "\n</AppendedData>\n</VTKFile>\n"
    );
}


Foam::fileName Foam::vtpFile::partName(const word& name)
{
    return
        Pstream::master()
      ? fileName(name + ".vtp")
      : fileName(name + '_' + Foam::name(Pstream::myProcNo()) + ".vtp");
}


void Foam::vtpFile::removeParts(const fileName& folder)
{
    for (const fileName& file : readDir(folder, fileName::FILE))
    {
        if (file.ext() == "vtp" && file.find('_') != std::string::npos)
        {
            rm(folder/file);
        }
    }
}


void Foam::vtpFile::saveSeries
(
    const fileName& directory,
    const word& name,
    const scalar upTo
)
{
    instantList times;
    for (const fileName& folder : readDir(directory, fileName::DIRECTORY))
    {
        scalar value;
        if
        (
            readScalar(folder.c_str(), value) && value <= upTo*(1 + 1e-12)
         && isFile(directory/folder/(name + ".vtp"), false)
        )
        {
            times.append(instant(value, folder));
        }
    }
    sort(times, instant::less());

    std::string xml
    (
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\""
        " version=\"0.1\">\n<Collection>\n"
    );
    for (const instant& t : times)
    {
        fileName file(name + ".vtp");
        for (label part = 0; isFile(directory/t.name()/file, false); ++part)
        {
            xml += "<DataSet timestep=\"" + t.name() + '"';
            xml += part ? " part=\"" + std::to_string(part) + '"' : "";
            xml += " file=\"" + t.name() + '/' + file + "\"/>\n";
            file = name + '_' + Foam::name(part + 1) + ".vtp";
        }
    }
    saveText
    (
        directory/(name + ".pvd"),
        xml + "</Collection>\n</VTKFile>\n"
    );
}


// ************************************************************************* //
