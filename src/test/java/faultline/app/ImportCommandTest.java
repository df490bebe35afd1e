package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.scenario.Scenario;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ImportCommandTest {

    @TempDir
    private Path folder;

    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    private int importMap(String... arguments) throws Exception {
        StringBuilder image = new StringBuilder("P2 40 40 255\n");
        for (int i = 0; i < 1600; i++) {
            image.append(i % 40 == 3 ? "0 " : "255 ");
        }
        Path map = Files.writeString(folder.resolve("map.pgm"), image);
        List<String> all = new ArrayList<>(List.of("import", map.toString()));
        all.addAll(List.of(arguments));
        return commandLine().run(all.toArray(new String[0]));
    }

    private CommandLine commandLine() {
        return new CommandLine(new CommandOutput(new PrintStream(out, true), new PrintStream(err, true)));
    }

    @ParameterizedTest
    @CsvSource({
        "negat: 1, negat, negate",
        "occupied_tresh: 0.6, occupied_tresh, occupied_thresh",
        "Mode: raw, Mode, mode",
        "'{image: map.pgm, resolution: 0.05, free_tresh: 0.1}', free_tresh, free_thresh"
    })
    void aKeyOfAMapThatMayBeMisspeltIsNoted(String line, String given, String known) throws Exception {
        importMap("--out", folder.resolve("image.xml").toString(), "--resolution", "0.05", "--start", "1,1.5,90");
        Path map = folder.resolve("map.yaml");
        Files.writeString(map, line.startsWith("{") ? line : "image: map.pgm\nresolution: 0.05\nsensor: x\n" + line);
        Path file = folder.resolve("room.xml");
        String[] arguments = {"import", map.toString(), "--out", file.toString(), "--start", "1,1.5,90"};
        assertEquals(0, commandLine().run(arguments), err::toString);
        assertEquals(
                List.of(map + ": \"" + given + "\" is not a key of maps and is ignored; did you mean \"" + known
                        + "\"?"),
                err.toString().lines().toList());
        assertTrue(Files.exists(file));
    }

    @Test
    void anImageBecomesAScenarioThatCanBeRun() throws Exception {
        Path file = folder.resolve("room.xml");
        assertEquals(
                0, importMap("--out", file.toString(), "--resolution", "0.05", "--start", "1,1.5,90"), err::toString);
        Scenario scenario = Scenario.load(file);
        assertEquals(2.0, scenario.setup().world().width());
        assertEquals(new Pose(1, 1.5, Math.PI / 2), scenario.setup().start());
        assertEquals(
                List.of(
                        "scenario: " + file,
                        "cells: 40 x 40",
                        "solid_cells: 40",
                        "rings: 1",
                        "segments: 4",
                        "start: 1,1.5,90"),
                out.toString(StandardCharsets.UTF_8).lines().toList());
    }

    @Test
    void aGroupOfOneCellIsKeptUnlessMoreAreWanted() throws Exception {
        Path map = Files.writeString(
                folder.resolve("spot.pgm"), "P2 40 40 255\n" + "255 ".repeat(820) + "0 " + "255 ".repeat(779));
        String[] command = {
            "import", map.toString(), "--out", folder + "/x.xml", "--resolution=0.05", "--start=0.3,0.3,0"
        };
        assertEquals(0, commandLine().run(command), err::toString);
        assertTrue(out.toString(StandardCharsets.UTF_8).contains("solid_cells: 1\n"));
        out.reset();
        String[] without = Arrays.copyOf(command, command.length + 1);
        without[command.length] = "--min-cells=2";
        assertEquals(0, commandLine().run(without), err::toString);
        assertTrue(out.toString(StandardCharsets.UTF_8).contains("solid_cells: 0\n"));
    }

    /** A column of twenty grey cells is neither free nor occupied. */
    @Test
    void unknownCellsAreFreeOrWallsAsWanted() throws Exception {
        String row = "255 255 255 128 " + "255 ".repeat(26) + "\n";
        Path map = Files.writeString(folder.resolve("grey.pgm"), "P2 30 20 255\n" + row.repeat(20));
        for (String unknown : List.of("free", "wall")) {
            out.reset();
            String target = folder.resolve(unknown + ".xml").toString();
            String[] command = {
                "import",
                map.toString(),
                "--out",
                target,
                "--resolution",
                "0.1",
                "--unknown",
                unknown,
                "--start",
                "1.5,1,0"
            };
            assertEquals(0, commandLine().run(command), err::toString);
            List<String> lines = out.toString(StandardCharsets.UTF_8).lines().toList();
            assertEquals("cells: 30 x 20", lines.get(1));
            assertEquals("solid_cells: " + (unknown.equals("wall") ? 20 : 0), lines.get(2));
        }
    }

    /** A frame of black lines on white, or the other way round, with a wall of 37 grey cells. */
    @ParameterizedTest
    @CsvSource({
        "--smooth 0, 196",
        "--threshold 0.5, 233",
        "--negate, 196",
        "--negate --threshold 0.5, 233",
        "--negate --threshold=1, 196"
    })
    void lightOrDarkPixelsFromAThresholdOnAreSolid(String options, int solid) throws Exception {
        StringBuilder image = new StringBuilder("P2 50 50 255\n");
        for (int i = 0; i < 2500; i++) {
            boolean wall = i % 50 == 0 || i % 50 == 49 || i / 50 == 0 || i / 50 == 49;
            int light = wall ? 255 : i % 50 == 40 && i / 50 >= 5 && i / 50 < 42 ? 150 : 0;
            image.append(options.contains("--negate") ? light : 255 - light).append(' ');
        }
        Path map = Files.writeString(folder.resolve("frame.pgm"), image);
        List<String> command = new ArrayList<>(List.of("import", map.toString(), "--out", folder + "/frame.xml"));
        command.addAll(List.of("--resolution", "0.05", "--start", "1,1,0"));
        command.addAll(List.of(options.split(" ")));
        assertEquals(0, commandLine().run(command.toArray(new String[0])), err::toString);
        assertEquals(
                "solid_cells: " + solid,
                out.toString(StandardCharsets.UTF_8).lines().toList().get(2));
    }

    @Test
    void aMapWithoutRoomNamesTheOptionsOrTheKeysThatMayHelp() throws Exception {
        Path image = Files.writeString(folder.resolve("tiny.pgm"), "P2 2 2 255 9 255 255 9");
        Path map = Files.writeString(folder.resolve("tiny.yaml"), "image: tiny.pgm\nresolution: 0.05\n");
        String problem =
                "faultline: " + image + ": the robot, 0.25 m long and 0.2 m wide, has no room in the free space"
                        + " of this map of 0.1 x 0.1 m; what may help: ";
        assertEquals(
                2, commandLine().run("import", image.toString(), "--out", folder + "/x.xml", "--resolution", "0.05"));
        assertEquals(
                problem + "--resolution, --threshold, --negate, --unknown or --start\n",
                err.toString(StandardCharsets.UTF_8));
        err.reset();
        assertEquals(2, commandLine().run("import", map.toString(), "--out", folder + "/x.xml"));
        assertEquals(
                problem + "resolution, occupied_thresh and negate in the map file, --unknown or --start\n",
                err.toString(StandardCharsets.UTF_8));
        err.reset();
        assertEquals(2, commandLine().run("import", map.toString(), "--out", folder + "/x.xml", "--smooth", "30"));
        assertEquals(
                problem + "resolution, occupied_thresh and negate in the map file, --unknown, --smooth or --start\n",
                err.toString(StandardCharsets.UTF_8));
    }

    @Test
    void theResolutionOfAYamlFileIsItsOwn() throws Exception {
        importMap("--out", "x.xml");
        err.reset();
        Path map =
                Files.writeString(folder.resolve("map.yaml"), "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n");
        assertEquals(2, commandLine().run("import", map.toString(), "--out", "x.xml", "--resolution", "1"));
        assertEquals(
                "faultline: --resolution is for an image; " + map + " gives its own (see faultline --help)\n",
                err.toString(StandardCharsets.UTF_8));
        err.reset();
        assertEquals(2, commandLine().run("import", map.toString(), "--out", "x.xml", "--negate"));
        assertEquals(
                "faultline: --negate is for an image; " + map + " gives its own (see faultline --help)\n",
                err.toString(StandardCharsets.UTF_8));
    }

    @Test
    void aMissingImageIsReportedBeforeAMissingResolution() throws Exception {
        Path none = folder.resolve("none.png");
        assertEquals(2, commandLine().run("import", none.toString(), "--out", folder + "/x.xml"));
        assertEquals("faultline: " + none + ": there is no such image file\n", err.toString(StandardCharsets.UTF_8));
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "links may not be permitted")
    void aFileOfWhichNobodyCanTellWhetherItExistsIsNotCalledMissing() throws Exception {
        // As in a folder without permission, from which a superuser is not kept.
        Path loop = folder.resolve("loop");
        Files.createSymbolicLink(loop, loop);
        Path map = Files.writeString(folder.resolve("map.yaml"), "image: loop/map.pgm\nresolution: 1\n");
        for (Path given : List.of(map, loop.resolve("map.yaml"), loop.resolve("map.pgm"))) {
            err.reset();
            String[] command = {"import", given.toString(), "--out", folder + "/x.xml", "--resolution=1"};
            int words = given.toString().endsWith(".pgm") ? 5 : 4;
            assertEquals(2, commandLine().run(Arrays.copyOf(command, words)));
            Path unreadable = given.equals(map) ? loop.resolve("map.pgm") : given;
            assertEquals(
                    "faultline: " + unreadable + ": the file cannot be read\n", err.toString(StandardCharsets.UTF_8));
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            --resolution 0.05                    | import needs --out FILE, the scenario file to write
            --out x.xml                          | an image needs --resolution M, the side of a pixel in metres
            --out x.xml --resolution 0           | --resolution is "0"; expected a number of metres from 0.000001 to 100000
            --out x.xml --resolution 1e-400      | --resolution is "1e-400"; expected a number of metres from 0.000001 to 100000
            --out x.xml --resolution 1 --threshold 1.1 | --threshold is "1.1"; expected a number from 0 to 1
            --out x.xml --resolution 1 --unknown no | --unknown is "no"; expected free or wall
            --out x.xml --resolution 1 --min-cells -1 | --min-cells is "-1"; expected a whole number from 0 to 999999999
            --out x.xml --resolution 1 --smooth -1 | --smooth is "-1"; expected a number of cells from 0 to 100000
            --out x.xml --resolution 1 --start 1,2 | --start is "1,2"; expected x,y,heading; x and y from -100000 to 100000 metres, heading from -1000000 to 1000000 degrees
            --out x.xml --resolution 1 --start 1,2,3,4 | --start is "1,2,3,4"; expected x,y,heading; x and y from -100000 to 100000 metres, heading from -1000000 to 1000000 degrees
            --out x.xml --resolution 1 --start -100001,2,3 | --start is "-100001,2,3"; expected x,y,heading; x and y from -100000 to 100000 metres, heading from -1000000 to 1000000 degrees
            --out x.xml --resolution 1 --start 1,2,1000001 | --start is "1,2,1000001"; expected x,y,heading; x and y from -100000 to 100000 metres, heading from -1000000 to 1000000 degrees
            --out x.xml --resolution 1 --start 1,2,1e999 | --start is "1,2,1e999"; expected x,y,heading; x and y from -100000 to 100000 metres, heading from -1000000 to 1000000 degrees
            """)
    void badUsageIsReported(String arguments, String sentence) throws Exception {
        assertEquals(2, importMap(arguments.split(" ")));
        assertEquals("faultline: " + sentence + " (see faultline --help)\n", err.toString(StandardCharsets.UTF_8));
    }
}
