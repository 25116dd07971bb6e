/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


Description
    Files for ParaView: what is written is read again, to the last bit; a file
    that is not whole is an error that names it; the series lists the times.

\*---------------------------------------------------------------------------*/

#include "demCase.H"
#include "OSspecific.H"
#include "vtpFile.H"

#include <fstream>
#include <random>
#include <sstream>

using namespace Foam;
using namespace styxTest;

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

const fileName folder("vtpFileTest");

std::string contentOf(const fileName& file)
{
    std::ifstream is(file, std::ios::binary);
    std::ostringstream os;
    os << is.rdbuf();
    return os.str();
}


struct values
{
    pointField x;
    vectorField v;
    scalarField d;
    labelList id;

    explicit values(const label n)
    :
        x(n), v(n), d(n), id(n)
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> u(-1, 1);
        forAll(x, i)
        {
            x[i] = point(u(random), u(random), u(random));
            v[i] = 1e-3*x[i];
            d[i] = std::exp(10*u(random));
            id[i] = 7*i;
        }
    }

    void save(const fileName& file) const
    {
        vtpFile out(x);
        out.write("velocity", v);
        out.write("diameter", d);
        out.write("id", id);
        out.save(file);
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(vtpFile, readAgain)
{
    // None; one block; several blocks, 48,000 points have 1.15 MB
    for (const label n : {0, 1, 100, 48000})
    {
        const values a(n);
        a.save(folder/"good.vtp");
        const vtpFile in(folder/"good.vtp");
        EXPECT_EQ(in.points(), a.x);
        EXPECT_EQ(in.vectors("velocity"), a.v);
        EXPECT_EQ(in.scalars("diameter"), a.d);
        EXPECT_EQ(in.labels("id"), a.id);
        EXPECT_EQ(in.names(), wordList({"velocity", "diameter", "id"}));
    }
    EXPECT_FALSE(isFile(folder/"good.vtp.part"));

    const vtpFile in(folder/"good.vtp");
    EXPECT_NE(messageOf([&]() { in.scalars("none"); }).find("none"),
        std::string::npos);
    EXPECT_NE(messageOf([&]() { in.scalars("id"); }).find("id"),
        std::string::npos);
    rmDir(folder);
}


TEST(vtpFile, smaller)
{
    // Bodies at rest, ids in order
    values a(10000);
    a.v = Zero;
    a.d = 0.01;
    a.save(folder/"rest.vtp");
    figure
    (
        "vtpSize", fileSize(folder/"rest.vtp")/(8.0*8*10000), -noBar, 0.5,
        "of the numbers' own", "zlib; places at random do not shrink"
    );
    rmDir(folder);
}


TEST(vtpFile, broken)
{
    values(1000).save(folder/"good.vtp");
    const std::string good(contentOf(folder/"good.vtp"));
    const fileName file(folder/"broken.vtp");

    const auto said = [&](const std::string& content)
    {
        std::ofstream(file, std::ios::binary) << content;
        return messageOf([&]() { vtpFile in(file); });
    };

    label silent = 0;
    for (size_t part = 0; part < 20; ++part)
    {
        const size_t end = good.find("\n</AppendedData>");
        const std::string message(said(good.substr(0, part*end/20)));
        silent += message.find("broken.vtp") == std::string::npos;
    }
    figure("vtpTruncated", silent, 0, 0, "not found of 20", "zlib, lengths");

    // A bit in the compressed numbers
    silent = 0;
    const size_t start = good.find("\n_") + 2;
    std::mt19937 random(3);
    for (label trial = 0; trial < 200; ++trial)
    {
        std::string bad(good);
        const size_t k =
            start + random() % (good.find("\n</AppendedData>") - start);
        bad[k] ^= 1 << random() % 8;
        silent += said(bad).find("broken.vtp") == std::string::npos;
    }
    figure("vtpFlipped", silent, 0, 0, "not found of 200", "checksum of zlib");

    EXPECT_NE(messageOf([&]() { vtpFile in("none.vtp"); }).find("none.vtp"),
        std::string::npos);
    rmDir(folder);
}


TEST(vtpFile, series)
{
    const values a(2);
    for (const char* time : {"0.1", "0.02", "1", "1.5"})
    {
        a.save(folder/time/"demCloud.vtp");
    }
    mkDir(folder/"0.5");
    mkDir(folder/"notATime");

    // The run went to 1.5 once, and was started again from 0.1
    vtpFile::saveSeries(folder, "demCloud", 1);
    const std::string text(contentOf(folder/"demCloud.pvd"));
    const auto at = [&](const std::string& t)
    {
        return text.find
        (
            "timestep=\"" + t + "\" file=\"" + t + "/demCloud.vtp\""
        );
    };
    const size_t first = at("0.02");
    const size_t second = at("0.1");
    const size_t third = at("1");
    EXPECT_LT(first, second);
    EXPECT_LT(second, third);
    EXPECT_NE(third, std::string::npos);
    EXPECT_EQ(text.find("1.5"), std::string::npos);
    EXPECT_EQ(text.find("0.5"), std::string::npos);
    rmDir(folder);
}


TEST(vtpFile, lines)
{
    // Three lines of two points each
    const values v(6);
    vtpFile out(v.x, true);
    out.write("diameter", v.d);
    out.save(folder/"lines.vtp");

    const std::string text = contentOf(folder/"lines.vtp");
    for
    (
        const char* const part :
        {
            "NumberOfPoints=\"6\"", "NumberOfVerts=\"0\"",
            "NumberOfLines=\"3\"", "<Lines>", "</Lines>"
        }
    )
    {
        EXPECT_NE(text.find(part), std::string::npos) << part;
    }
    const vtpFile in(folder/"lines.vtp");
    EXPECT_EQ(in.points(), v.x);
    EXPECT_EQ(in.scalars("diameter"), v.d);
    rmDir(folder);
}


// ************************************************************************* //
