package faultline.floorplan;

import static faultline.floorplan.CellState.FREE;
import static faultline.floorplan.CellState.OCCUPIED;
import static faultline.floorplan.CellState.UNKNOWN;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import faultline.geometry.Pose;
import faultline.scenario.xml.ScenarioException;
import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BandedSampleModel;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests maps from files: which pixels are solid, and the messages for files that are not maps. */
class FloorPlanTest {

    private static final String PLAIN = "P2\n# made by hand\n3 2\n255\n0 255 205\n255 0 254\n";

    @TempDir
    private Path folder;

    @Test
    void theFirstRowOfAnImageIsTheTopOfTheMap() throws IOException {
        OccupancyGrid grid = read(write("m.pgm", PLAIN), "").grid();
        assertEquals(List.of(FREE, OCCUPIED, FREE), row(grid, 0));
        assertEquals(List.of(OCCUPIED, FREE, UNKNOWN), row(grid, 1));
    }

    /** The byte after the carriage return that ends the header. */
    @Test
    void aLineFeedMayBeTheFirstPixel() throws IOException {
        OccupancyGrid grid =
                read(writeBytes("w.pgm", "P5 2 1 255\r\n", 254), "").grid();
        assertEquals(List.of(OCCUPIED, FREE), row(grid, 0));
    }

    @Test
    void rawAndPlainImagesOfAnyDepthAreReadAlike() throws IOException {
        OccupancyGrid expected = read(write("m.pgm", PLAIN), "").grid();
        assertEquals(
                expected,
                read(writeBytes("r.pgm", "P5 3 2 255\n", 0, 255, 205, 255, 0, 254), "")
                        .grid());
        String comments = "P5#raw\n3#columns\n2#rows\n255#white\n";
        assertEquals(
                expected,
                read(writeBytes("c.pgm", comments, 0, 255, 205, 255, 0, 254), "")
                        .grid());
        assertEquals(
                expected,
                read(writeBytes("w.pgm", "P5\r\n3 2\r\n255\r\n", 0, 255, 205, 255, 0, 254), "")
                        .grid());
        int[] deep = {0, 0, 255, 255, 205, 205, 255, 255, 0, 0, 254, 254};
        assertEquals(
                expected, read(writeBytes("d.pgm", "P5 3 2 65535\n", deep), "").grid());
        assertEquals(
                expected,
                read(write("s.pgm", "P2 3 2 100 0 100 80 100 0 99"), "").grid());
    }

    /** The values that the documentation names, with and without a YAML file. */
    @Test
    void withoutThresholdsThoseOfTheMapServerHold() throws IOException {
        Path image = write("t.pgm", "P2 4 1 255 89 90 205 206\n");
        List<?> expected = List.of(OCCUPIED, UNKNOWN, UNKNOWN, FREE);
        assertEquals(expected, row(read(image, "").grid(), 0));
        FloorPlan plain = FloorPlan.read(MapDescription.of(image, new BigDecimal("0.05")), FloorPlan.Options.DEFAULT);
        assertEquals(expected, row(plain.grid(), 0));
    }

    @Test
    void anOccupancyThatEqualsAThresholdMeetsItAtEveryDepth() throws IOException {
        for (int percent = 1; percent < 100; percent++) {
            String share = String.format(Locale.ROOT, "0.%02d", percent);
            Path image = write("e.pgm", "P2 2 1 100 " + (100 - percent) + " 0\n");
            String thresholds = "occupied_thresh: " + share + "\nfree_thresh: 0\n";
            assertEquals(OCCUPIED, read(image, thresholds).grid().state(0, 0), share);
            thresholds = "occupied_thresh: 1\nfree_thresh: " + share + "\n";
            assertEquals(FREE, read(image, thresholds).grid().state(0, 0), share);
        }
    }

    @Test
    void anImageThatEndsTooEarlyOrIsDamagedIsReportedInWords() throws IOException {
        Path bmp = folder.resolve("m.bmp");
        ImageIO.write(new BufferedImage(40, 30, BufferedImage.TYPE_INT_RGB), "bmp", bmp.toFile());
        Files.write(bmp, Arrays.copyOf(Files.readAllBytes(bmp), 200));
        assertEquals(
                bmp + ": the image cannot be read: the file ends too early",
                assertThrows(FloorPlanException.class, () -> read(bmp, "")).getMessage());
        Path tiff = folder.resolve("m.tif");
        ImageIO.write(new BufferedImage(40, 30, BufferedImage.TYPE_BYTE_GRAY), "tiff", tiff.toFile());
        byte[] bytes = Files.readAllBytes(tiff);
        Set<String> messages = new TreeSet<>();
        for (int at = 0; at < bytes.length; at++) {
            byte[] damaged = bytes.clone();
            damaged[at] ^= 0x11;
            Files.write(tiff, damaged);
            try {
                read(tiff, "");
            } catch (FloorPlanException e) {
                messages.add(e.getMessage());
            }
        }
        assertTrue(messages.contains(tiff + ": the image cannot be read: the file is damaged"), messages::toString);
        assertTrue(messages.stream().noneMatch(message -> message.contains("because \"")), messages::toString);
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "bmp", "gif", "tiff"})
    void greyImagesKeepTheirNumbers(String format) throws IOException {
        BufferedImage image = new BufferedImage(256, 1, BufferedImage.TYPE_BYTE_GRAY);
        for (int x = 0; x < 256; x++) {
            image.getRaster().setSample(x, 0, 0, x);
        }
        Path file = folder.resolve("grey." + format);
        if (ImageIO.write(image, format, file.toFile())) {
            OccupancyGrid grid =
                    read(file, "occupied_thresh: 0.65\nfree_thresh: 0.25\n").grid();
            for (int value = 0; value < 256; value++) {
                double p = (255 - value) / 255.0;
                assertEquals(p >= 0.65 ? OCCUPIED : p <= 0.25 ? FREE : UNKNOWN, grid.state(value, 0), "value " + value);
            }
        }
    }

    @Test
    void aPixelThatIsNotFullyOpaqueIsUnknown() throws IOException {
        BufferedImage image = new BufferedImage(3, 1, BufferedImage.TYPE_INT_ARGB);
        image.setRGB(0, 0, 0xff000000);
        image.setRGB(1, 0, 0xfe000000);
        image.setRGB(2, 0, 0x00ffffff);
        Path file = folder.resolve("a.png");
        ImageIO.write(image, "png", file.toFile());
        assertEquals(List.of(OCCUPIED, UNKNOWN, UNKNOWN), row(read(file, "").grid(), 0));
    }

    @Test
    void sixteenBitsOfOpacityAreComparedExactly() throws IOException {
        ComponentColorModel colors = new ComponentColorModel(
                ColorSpace.getInstance(ColorSpace.CS_sRGB),
                true,
                false,
                Transparency.TRANSLUCENT,
                DataBuffer.TYPE_USHORT);
        BufferedImage image = new BufferedImage(colors, colors.createCompatibleWritableRaster(2, 1), false, null);
        image.getRaster().setPixel(0, 0, new int[] {0, 0, 0, 65535});
        image.getRaster().setPixel(1, 0, new int[] {0, 0, 0, 65534});
        Path file = folder.resolve("a16.png");
        ImageIO.write(image, "png", file.toFile());
        assertEquals(List.of(OCCUPIED, UNKNOWN), row(read(file, "").grid(), 0));
    }

    @Test
    void negateAndModesFollowMapServer() throws IOException {
        Path file = write("m.pgm", "P2 4 1 255 0 50 100 255");
        assertEquals(
                List.of(OCCUPIED, OCCUPIED, UNKNOWN, FREE), row(read(file, "").grid(), 0));
        assertEquals(
                List.of(FREE, UNKNOWN, UNKNOWN, OCCUPIED),
                row(read(file, "negate: 1\n").grid(), 0));
        for (String no : List.of("0", "false", "No", "OFF")) {
            assertEquals(
                    List.of(OCCUPIED, OCCUPIED, UNKNOWN, FREE),
                    row(read(file, "negate: " + no + "\n").grid(), 0));
        }
        assertEquals(
                List.of(FREE, UNKNOWN, OCCUPIED, UNKNOWN),
                row(read(file, "mode: raw\n").grid(), 0));
        // ROS 1 inverts the values of this mode too, ROS 2 does not.
        assertEquals(
                List.of(FREE, UNKNOWN, OCCUPIED, UNKNOWN),
                row(read(file, "mode: raw\nnegate: 1\n").grid(), 0));
        assertEquals(
                List.of(OCCUPIED, OCCUPIED, UNKNOWN, FREE),
                row(read(file, "mode: 'scale'\n").grid(), 0));
    }

    @Test
    void unknownCellsAreSolidOnRequest() throws IOException {
        Path yaml = yaml(write("m.pgm", PLAIN), "");
        assertEquals(
                2, FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT).solid().count());
        assertEquals(
                3,
                FloorPlan.readYaml(yaml, new FloorPlan.Options(true, 1, 0))
                        .solid()
                        .count());
    }

    @Test
    void commentsQuotesAndListsInLinesAreUnderstood() throws IOException {
        write("m.pgm", PLAIN);
        Path yaml = write(
                "m.yaml",
                """
                # a map
                ---
                image: "m.pgm"   # beside this file
                resolution: 5e-2
                origin:
                  - -10
                  - 2.5
                  - 0.5
                free_thresh: 0.196
                occupied_thresh: 0.65
                negate: 0
                author: nobody
                """);
        MapDescription description =
                FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT).description();
        assertEquals(new BigDecimal("0.05"), description.resolution().stripTrailingZeros());
        assertEquals(0.5, description.yaw());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{image: m.pgm, resolution: 5e-2, origin: [-10, 2.5, 0.5], negate: 1}",
                "{image: m.pgm,resolution: 0.05,origin: [-10,2.5,0.5],negate: 1}",
                "{'a, b': 1, image: m.pgm, \"c, {\": 2, resolution: 0.05, origin: [-10, 2.5, 0.5], negate: 1}",
                "{is: it? 'tis, image: m.pgm, resolution: 0.05, origin: [-10, 2.5, 0.5], negate: 1}",
                "{note: '', image: 'm.pgm', resolution: 0.05, origin: [-10, 2.5, 0.5], negate: 1}",
                "{\"image\": \"m.pgm\", \"resolution\": 0.05, \"origin\": [-10, 2.5, 0.5], \"negate\": 1}",
                "%YAML 1.2\n---\n{ # all\n  image: 'm.pgm',\n  resolution: 0.05, # m\n"
                        + "  origin: [-10,\n 2.5,\n 0.5],\n negate: 1,\n}\n",
                "image: m.pgm\r\nresolution: 0.05\r\norigin: [-10, # x\r\n  2.5, 0.5\r\n]\r\nnegate: On\r\n",
                "\uFEFFimage: m.pgm\nresolution: 0.05\norigin:\n- -10\n- 2.5\n- 0.5\n"
                        + "negate: TRUE\nnote: it's [open # \"here\n",
                "image: m.pgm\nresolution: 0.05\norigin: [-10, 2.5, 0.5, ]\nnegate: 1\nmode: Trinary\n",
                "image:\n  m.pgm\nresolution:\n  0.05\norigin:\n\n  [-10,\n  2.5, 0.5]\nnegate: 1\n",
                "image: m.pgm\nresolution: 0.05\norigin:\n-\t-10\n-\t2.5\n-\t0.5\nnegate: 1\n",
                "--- {image: m.pgm, resolution: !!float '0.05',\n  origin: [-10, 2.5, !!float \"0.5\"], negate: 1}\n",
                "{note: \"a }\\\n  # b\", image: m.pgm, resolution: 0.05, meta: {x: ['y [\n# ''{z', it 's],\n w: 1},\n"
                        + "origin: [-10, 2.5, '0.5'], negate: 1}\n",
                "note: of \"Bob\nwho: - 'Bob\nimage: 'm.pgm'\nresolution: \"0.05\"\nnegate: 1\n"
                        + "origin:\n- |-\n  -10\n- !!float \"2.5\"\n- '0.5'\n",
                "{note: !!str \"a }, b: [\", image: m.pgm, resolution: 0.05, origin: [-10, 2.5, 0.5], negate: 1}",
                "image: m.pgm\nresolution: &r 0.05\norigin: &o !!seq [-10,\n 2.5, 0.5]\nnegate: 1\n",
                "image: m.pgm\nresolution: 0.05\norigin:\n  !!seq [-10, 2.5, 0.5]\nnegate: 1\n",
                "image: m.pgm\nresolution: 0.05\norigin: &o\n  - -10\n  - 2.5\n  - &yaw 0.5\nnegate: 1\n",
                "{image: m.pgm, resolution: 0.05, origin: !!seq [-10, 2.5, 0.5], negate: 1}",
                "image: m.pgm # a hall\u2028\u0085\fof Bob\nresolution: 0.05\norigin: [-10, 2.5, 0.5]\rnegate: 1\n",
                "about: |\n  A hall [1\n  with: walls\n\n  # 7\nmeta:\n  image: b.pgm\n  resolution: 7\n"
                        + "image: m.pgm\nresolution: 0.05\nrooms:\n- name: a\n  image: c\n-\n  name: b\n"
                        + "  image: d\norigin: [-10, 2.5, 0.5]\nnegate: 1\nwhy: some words\n  and more\n"
            })
    void bracesListsOverSeveralLinesAndMarksAreUnderstood(String content) throws IOException {
        write("m.pgm", PLAIN);
        Path yaml = write("m.yaml", content);
        MapDescription description =
                FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT).description();
        assertEquals(new BigDecimal("0.05"), description.resolution().stripTrailingZeros());
        assertEquals(0.5, description.yaw());
        assertTrue(description.negate());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            textBlock =
                    """
            Bob's hall: "west" # 2.pgm | 'Bob''s hall: "west" # 2.pgm'
            Bob's hall: "west" # 2.pgm | "Bob's hall: \\"west\\" # 2.pgm" # a comment
            Bob's hall, west.pgm       | Bob's@  hall,@@   west.pgm
            Bob's hall, west.pgm       | 'Bob''s@  hall, west.pgm'
            Bob's hall,  west.pgm      | "Bob's@  hall,\\@  \\  west.pgm"
            a # b: - c.pgm             | "a@  # b:@@  - c.pgm" # a comment
            a - b.pgm                  | 'a@  - b.pgm'
            a - b.pgm                  | a@  - b.pgm
            hall.pgm                   | >-@  hall.pgm@
            hall.pgm                   | "h\\x61\\u006c\\U0000006C.pgm"
            C\\maps\\x.pgm             | "C\\maps\\x.pgm"
            x\\uD83G.pgm               | "x\\uD83G.pgm"
            ''.pgm                     | "''.pgm"
            """)
    void theNameOfAnImageIsPlainOrQuoted(String name, String scalar) throws IOException {
        write(name, PLAIN);
        Path yaml = write("m.yaml", "image: " + scalar.replace('@', '\n') + "\nresolution: 0.05\n");
        FloorPlan plan = FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT);
        assertEquals(folder.resolve(name), plan.description().image());
    }

    @Test
    void aLongValueInManyLinesIsReadInLinearTime() throws IOException {
        CpuTime time = CpuTime.start();
        Path yaml = write("m.yaml", "resolution: 1\nimage: x\n" + " y\n".repeat(300_000));
        IOException e =
                assertThrows(FloorPlanException.class, () -> FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT));
        assertTrue(e.getMessage().startsWith(yaml + ":2:8: image is \"x y y y"), e::getMessage);
        Path open = write("open.yaml", "{resolution: 1, image: 'x\n" + "y\n".repeat(300_000) + "\"z\n".repeat(50_000));
        e = assertThrows(FloorPlanException.class, () -> FloorPlan.readYaml(open, FloorPlan.Options.DEFAULT));
        assertTrue(e.getMessage().startsWith(open + ":1:1: there is no"), e::getMessage);
        String tags = "!".repeat(400_000) + " image: x\n" + " y\n".repeat(200_000) + "resolution: 1\n";
        write("m.yaml", tags);
        e = assertThrows(FloorPlanException.class, () -> FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT));
        assertTrue(e.getMessage().contains("image is \"x y y y"), e::getMessage);
        time.assertBelow(10);
    }

    /** From every line on, some mark that it contains remains open to the end of the file. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "notes: [\n * , \"a\", \"b\n",
                "notes: [\n * , \"a', \"b\", 'c\n , \"a', 'b', \"c\n",
                "mode:\n * , \"a\", \"b\n",
                "mode:\n *  - \"a\n - 'b\n   - \"c\n",
                "mode: \"\n *\\\\\\\n "
            })
    void textsInQuotesWithoutEndTakeLinearTime(String content) throws IOException {
        write("m.pgm", PLAIN);
        String[] parts = content.split("\\*");
        String yaml = "image: m.pgm\nresolution: 1\n" + parts[0] + parts[1].repeat(800_000 / parts[1].length());
        Path file = write("m.yaml", yaml);
        CpuTime time = CpuTime.start();
        try {
            FloorPlan.readYaml(file, FloorPlan.Options.DEFAULT);
        } catch (FloorPlanException e) {
            assertTrue(e.getMessage().contains(":3:"), e::getMessage);
        }
        time.assertBelow(10);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            {image: m.pgm, resolution: fast}     | m.yaml:1:28: resolution is "fast"; expected a number
            {image: m.pgm, resolution 1}         | m.yaml:1:16: a line is "resolution 1"; expected "key: value"
            {image: m.pgm, resolution: 1         | m.yaml:1:1: there is no "image"; "{image" may be a misspelling of it
            {image: m.pgm,@ image: b}            | m.yaml:2:2: "image" is given twice; expected once
            {image: 'm.pgm, resolution: 1}       | m.yaml:1:1: there is no "resolution"; a map file needs it
            image: m.pgm@resolution: [1,@2       | m.yaml:2:13: resolution is "[1, 2"; expected a number
            """)
    void aWrongMappingInBracesIsReportedWithItsPlace(String content, String expected) throws IOException {
        write("m.pgm", PLAIN);
        Path yaml = write("m.yaml", content.replace('@', '\n'));
        IOException e =
                assertThrows(FloorPlanException.class, () -> FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT));
        assertEquals(folder + "/" + expected, e.getMessage().replace('\\', '/'));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            resolution: fast         | m.yaml:2:13: resolution is "fast"; expected a number
            resolution: 0            | m.yaml:2:13: resolution is "0"; expected a number of metres from 0.000001 to 100000
            resolution: 1e-400       | m.yaml:2:13: resolution is "1e-400"; expected a number of metres from 0.000001 to 100000
            resolution: 1e9          | m.yaml:2:13: resolution is "1e9"; expected a number of metres from 0.000001 to 100000
            resolution: 1@origin: [0, 0, 0, 1] | m.yaml:3:9: origin is "0, 0, 0, 1"; expected three numbers, [x, y, yaw] in metres and radians
            resolution: 1@origin: [0, 0, 1e6] | m.yaml:3:9: origin is "0, 0, 1e6"; expected [x, y, yaw] with a yaw of at most 17000 radians
            resolution 0.05          | m.yaml:2:1: a line is "resolution 0.05"; expected "key: value"
            resolutoin: 0.05         | m.yaml:1:1: there is no "resolution"; "resolutoin" may be a misspelling of it
            image: other.pgm         | m.yaml:2:1: "image" is given twice; expected once
            """)
    void aWrongMapFileIsReportedWithItsPlace(String line, String expected) throws IOException {
        write("m.pgm", PLAIN);
        Path yaml = write("m.yaml", "image: m.pgm\n" + line.replace('@', '\n') + "\n");
        IOException e =
                assertThrows(FloorPlanException.class, () -> FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT));
        assertEquals(folder + "/" + expected, e.getMessage().replace('\\', '/'));
    }

    /** Such a character would make an unknown key of a known one, which would be ignored. */
    @ParameterizedTest
    @CsvSource({"0, 0000", "27, 001B", "11, 000B", "127, 007F", "128, 0080"})
    void aControlCharacterInAMapFileIsReportedWithItsPlace(int character, String code) throws IOException {
        write("m.pgm", PLAIN);
        Path yaml = write("m.yaml", "image: m.pgm\r\nresolution: 1 # \t\n  " + (char) character + "negate: 1\n");
        IOException e =
                assertThrows(FloorPlanException.class, () -> FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT));
        assertEquals(
                yaml + ":3:3: the character U+" + code + " is not allowed in YAML; the file may be damaged",
                e.getMessage());
    }

    @Test
    void aFolderInThePlaceOfAnImageIsReported() throws IOException {
        Path yaml = write("m.yaml", "image: .\nresolution: 1\n");
        IOException e =
                assertThrows(FloorPlanException.class, () -> FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT));
        assertEquals(
                yaml + ":1:8: image is \".\"; expected the name of an image file, but " + yaml.resolveSibling(".")
                        + " is not a regular file",
                e.getMessage());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            P2 2 1 255 0             | pixel 2 is missing at byte 12
            P2 2 1 255 0 256         | pixel 2 is 256; expected 0 to 255
            P5 2 9 255 0             | the image ends after 1 bytes of pixels, 18 are needed
            P5 2 9 255               | the image ends after 0 bytes of pixels, 18 are needed
            P5 2 9 65535 0           | the image ends after 1 bytes of pixels, 36 are needed
            P5 99999 99999 255 0     | the image has 99999 x 99999 pixels; expected 1 to 64000000
            P5 99999999999 99999999999 255 | the image has 99999999999 x 99999999999 pixels; expected 1 to 64000000
            P5 0 1234567890123456789012345678901 9 | the image has 0 x 123456789012345678901234567890... pixels; \
            expected 1 to 64000000
            P5 2 1 99999999999 0     | the maximum value is 99999999999; expected 1 to 65535
            P2 2 1 255 0 99999999999 | pixel 2 is 99999999999; expected 0 to 255
            P6 2 1 255 0             | the format of the image is P6; expected P2 or P5
            P2 2 1 0 0 0             | the maximum value is 0; expected 1 to 65535
            P2 2 1 65536 0 0         | the maximum value is 65536; expected 1 to 65535
            P1 2 1 0 1               | the format of the image is P1; expected P2 or P5
            P7 2 1 255 0             | the format of the image is P7; expected P2 or P5
            P0 2 1 255 0             | the format of the image is not supported; expected PGM (P2, P5), PNG, BMP, GIF or TIFF
            P8 2 1 255 0             | the format of the image is not supported; expected PGM (P2, P5), PNG, BMP, GIF or TIFF
            P                        | the format of the image is not supported; expected PGM (P2, P5), PNG, BMP, GIF or TIFF
            P2 2                     | the height is missing at byte 4
            P2 2 x                   | the height is "x" at byte 5; expected a whole number
            P5 -5 5 255              | the width is "-5" at byte 3; expected a whole number
            P2 2 1 255 0 x1          | pixel 2 is "x1" at byte 13; expected a whole number
            not an image             | the format of the image is not supported; expected PGM (P2, P5), PNG, BMP, GIF or TIFF
            """)
    void aDamagedImageIsReportedInOneSentence(String content, String expected) throws IOException {
        Path image = write("m.pgm", content.strip());
        IOException e = assertThrows(
                FloorPlanException.class,
                () -> FloorPlan.read(MapDescription.of(image, new BigDecimal("0.05")), FloorPlan.Options.DEFAULT));
        assertEquals(image + ": " + expected, e.getMessage());
    }

    /** JPEG changes pixels, and neither format is one of those that the documentation lists. */
    @ParameterizedTest
    @ValueSource(strings = {"jpg", "wbmp"})
    void otherFormatsThatTheJdkReadsAreRefused(String format) throws IOException {
        Path image = folder.resolve("m." + format);
        int type = format.equals("jpg") ? BufferedImage.TYPE_BYTE_GRAY : BufferedImage.TYPE_BYTE_BINARY;
        assertTrue(ImageIO.write(new BufferedImage(40, 30, type), format, image.toFile()));
        IOException e = assertThrows(
                FloorPlanException.class,
                () -> FloorPlan.read(MapDescription.of(image, new BigDecimal("0.05")), FloorPlan.Options.DEFAULT));
        assertEquals(
                image + ": the format of the image is not supported; expected PGM (P2, P5), PNG, BMP, GIF or TIFF",
                e.getMessage());
    }

    @Test
    void aMapThatIsLargerThanAWorldIsRefused() throws IOException {
        Path image = write("m.pgm", PLAIN);
        IOException e = assertThrows(
                FloorPlanException.class,
                () -> FloorPlan.read(MapDescription.of(image, new BigDecimal("5e4")), FloorPlan.Options.DEFAULT));
        assertEquals(
                image
                        + ": the map measures 150000 x 100000 m; expected at most 100000 m;"
                        + " the resolution, which is the side of a pixel, may be wrong",
                e.getMessage());
    }

    @Test
    void aMapThatIsALittleTooLargeIsNotSaidToMeasureWhatIsAllowed() throws IOException {
        Path image = write("m.pgm", PLAIN);
        IOException e = assertThrows(
                FloorPlanException.class,
                () -> FloorPlan.read(MapDescription.of(image, new BigDecimal("33333.4")), FloorPlan.Options.DEFAULT));
        assertEquals(
                image
                        + ": the map measures 100001 x 66667 m; expected at most 100000 m;"
                        + " the resolution, which is the side of a pixel, may be wrong",
                e.getMessage());
    }

    @Test
    void aMapThatIsOnlyRotatedLargerThanAWorldIsRefused() throws IOException {
        Path image = write("m.pgm", PLAIN);
        Path yaml = write("m.yaml", "image: m.pgm\nresolution: 3e4\norigin: [0, 0, 0.785398]\n");
        IOException e =
                assertThrows(FloorPlanException.class, () -> FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT));
        assertEquals(
                image
                        + ": the map measures 106067 x 106067 m; expected at most 100000 m;"
                        + " the resolution, which is the side of a pixel, may be wrong",
                e.getMessage());
    }

    @Test
    void aMissingImageIsReported() throws IOException {
        Path yaml = write("m.yaml", "image: none.png\nresolution: 0.1\n");
        IOException e =
                assertThrows(FloorPlanException.class, () -> FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT));
        assertEquals(
                yaml + ":1:8: image is \"none.png\"; expected the name of an image file, but there is no file "
                        + folder.resolve("none.png"),
                e.getMessage());
        Path none = folder.resolve("none.png");
        IOException alone = assertThrows(
                FloorPlanException.class,
                () -> FloorPlan.read(MapDescription.of(none, new BigDecimal("0.05")), FloorPlan.Options.DEFAULT));
        assertEquals(none + ": there is no such image file", alone.getMessage());
    }

    @Test
    void theLongNameOfAMissingImageIsShortened() throws IOException {
        Path yaml = write("m.yaml", "image: " + "x".repeat(500_000) + "\nresolution: 0.1\n");
        IOException e =
                assertThrows(FloorPlanException.class, () -> FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT));
        assertEquals(
                yaml + ":1:8: image is \"" + "x".repeat(60) + "...\"; expected the name of an image file",
                e.getMessage());
    }

    @ParameterizedTest
    @CsvSource({"m.yaml, true", "M.YML, true", "m.yml.pgm, false", "yaml, false"})
    void aMapFileIsKnownByTheEndingOfItsName(String name, boolean isYaml) {
        assertEquals(isYaml, FloorPlan.isYaml(folder.resolve(name)));
    }

    @ParameterizedTest
    @CsvSource({"-1, 0", "0, -0.1", "0, NaN", "0, Infinity"})
    void theOptionsAreNotNegative(int minCells, double smoothing) {
        assertEquals(0, new FloorPlan.Options(false, 0, 0).minCells());
        assertThrows(IllegalArgumentException.class, () -> new FloorPlan.Options(false, minCells, smoothing));
    }

    /** A scenario could not hold the outlines; they are counted before they are traced. */
    @Test
    void aMapWithMoreWallSegmentsThanAScenarioHoldsIsRefusedInOneSentence() throws IOException, ScenarioException {
        FloorPlan.Options smooth = new FloorPlan.Options(false, 1, 1);

        FloorPlan largest = FloorPlan.readYaml(comb(24_999), FloorPlan.Options.DEFAULT);
        assertEquals(99_998, largest.segmentCount());
        FloorPlanScenario.create("comb", largest, new Pose(1, 0.7, 0)).save(folder.resolve("comb.xml"));
        Path tooLarge = comb(25_000);
        IOException e =
                assertThrows(FloorPlanException.class, () -> FloorPlan.readYaml(tooLarge, FloorPlan.Options.DEFAULT));
        assertEquals(
                folder.resolve("m.pgm") + ": the map has 100002 wall segments; expected at most 99999;"
                        + " drop specks, straighten outlines or use a coarser image",
                e.getMessage());
        assertTrue(FloorPlan.readYaml(tooLarge, smooth).segmentCount() < 10);
        FloorPlan.Options tooLittle = new FloorPlan.Options(false, 1, 0.1);
        IOException after = assertThrows(FloorPlanException.class, () -> FloorPlan.readYaml(tooLarge, tooLittle));
        assertEquals(e.getMessage(), after.getMessage());
    }

    /** A room above a wall with teeth, each of which has four corners; the ends of the wall add two. */
    private Path comb(int teeth) throws IOException {
        int roomRows = 20;
        String content = "P2 " + 2 * teeth + " " + (roomRows + 2) + " 255 " + "255 ".repeat(2 * teeth * roomRows)
                + "0 255 ".repeat(teeth) + "0 ".repeat(2 * teeth);
        return yaml(write("m.pgm", content), "");
    }

    @Test
    void aTiffOfFloatingPointNumbersIsRefused() throws IOException {
        BufferedImage image = new BufferedImage(
                new ComponentColorModel(
                        ColorSpace.getInstance(ColorSpace.CS_GRAY),
                        false,
                        false,
                        Transparency.OPAQUE,
                        DataBuffer.TYPE_FLOAT),
                Raster.createWritableRaster(new BandedSampleModel(DataBuffer.TYPE_FLOAT, 4, 4, 1), null),
                false,
                null);
        Path file = folder.resolve("f.tiff");
        assertTrue(ImageIO.write(image, "tiff", file.toFile()));
        IOException e = assertThrows(FloorPlanException.class, () -> read(file, ""));
        assertEquals(file + ": a pixel of the image has 32 bits; expected 1, 2, 4, 8 or 16", e.getMessage());
    }

    @Test
    void theSizeOfATiffIsReportedAsTheFileHasIt() throws IOException {
        int[][] tags = {{256, -1}, {257, -1}, {258, 8}, {259, 1}, {262, 1}, {273, 8}, {277, 1}, {278, 5}, {279, 25}};
        ByteBuffer tiff = ByteBuffer.allocate(14 + 12 * tags.length).order(ByteOrder.LITTLE_ENDIAN);
        tiff.put("II*\0".getBytes(StandardCharsets.ISO_8859_1)).putInt(8).putShort((short) tags.length);
        for (int[] tag : tags) {
            tiff.putShort((short) tag[0]).putShort((short) 4).putInt(1).putInt(tag[1]);
        }
        Path file = Files.write(folder.resolve("wide.tiff"), tiff.array());
        IOException e = assertThrows(FloorPlanException.class, () -> read(file, ""));
        assertEquals(file + ": the image has 4294967295 x 4294967295 pixels; expected 1 to 64000000", e.getMessage());
    }

    private FloorPlan read(Path image, String more) throws IOException {
        return FloorPlan.readYaml(yaml(image, more), FloorPlan.Options.DEFAULT);
    }

    private Path yaml(Path image, String more) throws IOException {
        return write("map.yaml", "image: " + image.getFileName() + "\nresolution: 0.05\n" + more);
    }

    private Path write(String name, String content) throws IOException {
        return Files.writeString(folder.resolve(name), content);
    }

    private Path writeBytes(String name, String header, int... pixels) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write(header.getBytes(StandardCharsets.US_ASCII));
        for (int pixel : pixels) {
            bytes.write(pixel);
        }
        return Files.write(folder.resolve(name), bytes.toByteArray());
    }

    private static List<CellState> row(OccupancyGrid grid, int row) {
        List<CellState> states = new ArrayList<>();
        for (int column = 0; column < grid.width(); column++) {
            states.add(grid.state(column, row));
        }
        return states;
    }
}
