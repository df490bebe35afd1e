package faultline.app;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.SamplePlan;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The commands {@code campaign}, {@code merge}, {@code report} and {@code figures}: exit codes and refusals. */
class CampaignCommandTest {

    @TempDir
    Path folder;

    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    @BeforeEach
    void writePlan() throws IOException {
        Files.writeString(folder.resolve("room.xml"), SamplePlan.ROOM);
        Files.writeString(
                folder.resolve("plan.xml"),
                SamplePlan.text(
                        "",
                        """
                        <worlds><scenario file="room.xml"/></worlds>
                        <seeds count="2"/>
                        <faults><healthy/><fault kind="off" sensor="front left" at="1..2"/></faults>
                        """));
    }

    /** Runs a command; an @ in its arguments is replaced by the folder. */
    private int command(String arguments) {
        out.reset();
        err.reset();
        PrintStream output = new PrintStream(out, true, StandardCharsets.UTF_8);
        PrintStream errors = new PrintStream(err, true, StandardCharsets.UTF_8);
        String[] words = arguments.replace("@", folder.toString()).split(" ");
        return new CommandLine(new CommandOutput(output, errors)).run(words);
    }

    private String errors() {
        return err.toString(StandardCharsets.UTF_8).replace(folder.toString(), "@");
    }

    /** Comments of a file may be long, and may name the other format. */
    @Test
    void checkRecognisesAPlanByItsRootElement() throws IOException {
        Path plan = folder.resolve("plan.xml");
        String text = Files.readString(plan).replaceFirst("<campaign", "<!-- " + "-x".repeat(9000) + " --><campaign");
        Files.writeString(plan, text);
        assertEquals(0, command("check @/plan.xml"), errors());
        assertTrue(out.toString(StandardCharsets.UTF_8).endsWith("good, 6 runs\n"), out::toString);
        Files.write(plan, text.getBytes(StandardCharsets.UTF_16));
        assertEquals(0, command("check @/plan.xml"), errors());
        Path room = folder.resolve("room.xml");
        Files.writeString(
                room, SamplePlan.ROOM.replaceFirst("<scenario", "<!-- for urn:faultline:campaign:1 --><scenario"));
        assertEquals(0, command("check @/room.xml"), errors());
        Files.writeString(plan, "<campaign xmlns=\"urn:faultline:campaign:1\" name=x>");
        assertEquals(2, command("check @/plan.xml"));
        assertTrue(errors().startsWith("@/plan.xml:1:49: this is not well-formed XML"), errors());
    }

    @Test
    void aPathThatNamesNoneOfSeveralElementsIsNoted() throws IOException {
        String sensors = "<robot x=\"0.6\" y=\"1.2\"><sensor id=\"left\" x=\"0\" y=\"0.1\" bearing=\"90\"/>"
                + "<sensor id=\"right\" x=\"0\" y=\"-0.1\" bearing=\"-90\"/></robot>";
        String room = SamplePlan.ROOM.replace("<robot x=\"0.6\" y=\"1.2\"/>", sensors);
        Files.writeString(folder.resolve("a.xml"), room);
        Files.writeString(folder.resolve("b.xml"), room);
        String text = SamplePlan.text(
                "",
                """
                <worlds><scenario file="a.xml"/><scenario file="b.xml"/></worlds>
                <set attribute="@duration" value="0.1"/>
                <set attribute="robot/sensor/@range" value="0.8 0.2"/>
                """);
        Files.writeString(folder.resolve("plan.xml"), text);
        String note = "@/plan.xml:4:55: \"robot/sensor/@range\" sets only the first of 2 elements <sensor>;"
                + " \"robot/sensor[left]/@range\" names one of them, by its id or number (in a)\n";
        assertEquals(0, command("check @/plan.xml"), errors());
        assertTrue(out.toString(StandardCharsets.UTF_8).endsWith("good, 4 runs\n"), out::toString);
        assertEquals(note, errors());
        assertEquals(0, command("campaign @/plan.xml --out @/out"), errors());
        assertEquals(note, errors());
        Files.writeString(folder.resolve("plan.xml"), text.replace("sensor/", "sensor[right]/"));
        assertEquals(0, command("check @/plan.xml"), errors());
        assertEquals("", errors());
    }

    @Test
    void aCampaignIsMadeInPartsMergedAndReported() throws IOException {
        assertEquals(0, command("campaign @/plan.xml --out @/whole"), errors());
        assertTrue(out.toString(StandardCharsets.UTF_8).endsWith("runs: 6\nbroken: 0\n"));
        assertEquals(0, command("campaign @/plan.xml --out @/a --shard 1/2 --jobs 1"), errors());
        assertEquals(0, command("campaign @/plan.xml --out @/b --shard 2/2 --resume"), errors());
        assertEquals(0, command("merge @/b @/a --out @/merged"), errors());
        assertArrayEquals(
                Files.readAllBytes(folder.resolve("whole/runs.csv")),
                Files.readAllBytes(folder.resolve("merged/runs.csv")));
        assertEquals(0, command("report @/merged --out @/page.html --table @/cells.csv"), errors());
        assertTrue(Files.readString(folder.resolve("page.html")).endsWith("</html>\n"));
        List<String> cells = Files.readAllLines(folder.resolve("cells.csv"));
        assertTrue(cells.get(0).startsWith("fault_kind,fault_sensor,final_rung,runs,carried_on,share,"), cells.get(0));
        assertEquals(
                List.of("none,,all,2", "off,front,all,2", "off,left,all,2", "off,all,all,4", "all,all,all,4"),
                List.of("none,,all", "off,front,all", "off,left,all", "off,all,all", "all,all,all").stream()
                        .map(key -> cells.stream()
                                .filter(line -> line.startsWith(key + ","))
                                .map(line -> key + "," + line.split(",")[3])
                                .findFirst()
                                .orElse(key + " is missing in " + cells))
                        .toList());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '~',
            quoteCharacter = '`',
            textBlock =
                    """
            campaign --out @/o                         ~ campaign takes one plan, not none
            campaign @/plan.xml @/plan.xml --out @/o   ~ campaign takes one plan, not 2
            campaign @/plan.xml                        ~ --out DIR is missing, the folder that the tables go to
            campaign @/plan.xml --out @/o --jobs 0     ~ --jobs is "0"; expected a whole number from 1 to 1024
            campaign @/plan.xml --out @/o --jobs two   ~ --jobs is "two"; expected a whole number from 1 to 1024
            campaign @/plan.xml --out @/o --jobs +3 --shard 0/4 ~ --shard is "0/4"; expected I/N with I from 1 to N, such as 2/4
            campaign @/plan.xml --out @/o --shard 5/4  ~ --shard is "5/4"; expected I/N with I from 1 to N, such as 2/4
            merge --out @/o                            ~ merge takes the folders of one or more parts, not none
            report --out @/o.html                      ~ report takes the folder of one campaign, not none
            report @/a @/b --out @/o.html              ~ report takes the folder of one campaign, not 2
            report @/a                                 ~ report needs --out FILE.html, the page that it writes
            figures                                    ~ figures needs --out DIR, the folder that they go to
            figures @/plan.xml --out @/o               ~ figures takes no file, only --out DIR and --theme light|dark|adaptive
            figures --out @/o --theme drak             ~ --theme is "drak"; expected light, dark or adaptive; did you mean "dark"?
            run a.xml --patience 5                     ~ --patience needs --controller COMMAND
            run a.xml --controller x --patience 0      ~ --patience is "0"; expected none or a number of seconds above 0, up to 10000000
            """)
    void badUsageEndsWithTwoAndSaysWhatIsExpected(String arguments, String problem) {
        String expected = "faultline: " + problem + " (see faultline --help)\n";
        assertEquals(2, command(arguments));
        assertEquals(expected, errors());
        assertTrue(Files.notExists(folder.resolve("o")));
    }

    @ParameterizedTest
    @CsvSource({
        "figures --out @/file/x, @/file/x: a part of this path is a file; expected a folder",
        "campaign @/plan.xml --out @/file/x, @/file/x: a part of this path is a file; expected a folder",
        "campaign @/plan.xml --out @/locked, @/locked/.lock: this is a folder; expected a file"
    })
    void aFolderThatCannotBeUsedIsReportedInTheProgramsOwnWords(String arguments, String problem) throws IOException {
        Files.createFile(folder.resolve("file"));
        Files.createDirectories(folder.resolve("locked/.lock"));
        assertEquals(2, command(arguments));
        assertEquals("faultline: " + problem, errors().strip());
    }

    @Test
    void aLinkThatLeadsNowhereIsNotCalledAFile() throws IOException {
        Files.createSymbolicLink(folder.resolve("link"), folder.resolve("nowhere"));
        assertEquals(2, command("campaign @/plan.xml --out @/link"));
        assertEquals("faultline: @/link: this link does not lead to a folder; expected a folder", errors().strip());
        Files.writeString(folder.resolve("file"), "kept");
        assertEquals(2, command("campaign @/plan.xml --out @/file"));
        assertEquals("faultline: @/file: this is a file; expected a folder", errors().strip());
        assertEquals("kept", Files.readString(folder.resolve("file")));
    }

    @Test
    void aFolderWithFilesOfTheSameNamesIsRefused() throws IOException {
        Files.writeString(folder.resolve("timing.csv"), "mine");
        assertEquals(2, command("campaign @/plan.xml --out @"));
        assertEquals(
                "faultline: @/timing.csv: the campaign would replace or delete this file,"
                        + " and the folder has no campaign.json; use another folder\n",
                errors());
        assertEquals("mine", Files.readString(folder.resolve("timing.csv")));
    }

    @Test
    void aFolderThatCannotBeReadIsNotSaidToBeWithoutACampaign() throws IOException {
        // As for a folder without permission, from which a superuser is not kept.
        Files.createSymbolicLink(folder.resolve("loop"), folder.resolve("loop"));
        for (String command : List.of("report @/loop --out @/page.html", "merge @/loop --out @/merged")) {
            assertEquals(2, command(command));
            assertEquals("faultline: @/loop: the folder cannot be read\n", errors());
        }
        assertEquals(2, command("report @/plan.xml --out @/page.html"));
        assertEquals("faultline: @/plan.xml: there is no campaign\n", errors());
        assertEquals(2, command("run @/room.xml --controller x --jar @/loop"));
        assertEquals("faultline: --jar is \"@/loop\", which cannot be read (see faultline --help)\n", errors());
    }

    @Test
    void whatCannotBeReadOrWrittenIsNamed() throws IOException {
        assertEquals(2, command("report @ --out @/page.html"));
        assertEquals("faultline: @: there is no campaign\n", errors());
        assertEquals(2, command("figures --out @/room.xml/figures"));
        assertTrue(errors().startsWith("faultline: @/room.xml"), errors());
        assertEquals(0, command("campaign @/plan.xml --out @/whole"), errors());
        Path table = folder.resolve("whole/runs.csv");
        List<String> rows = Files.readAllLines(table);
        for (String empty : List.of("", rows.get(0) + "\n")) {
            Files.writeString(table, empty);
            assertEquals(2, command("report @/whole --out @/page.html"));
            String expected = "there is no row of a run; expected at least one below the header";
            assertEquals("faultline: @/whole/runs.csv:1:1: " + expected + "\n", errors());
            assertTrue(Files.notExists(folder.resolve("page.html")));
        }
        Files.write(table, rows);
        assertEquals(2, command("report @/whole --out @/whole/runs.csv"));
        assertTrue(errors().contains("is an input or another output; expected another file"));
        assertEquals(2, command("report @/whole --out @/page.html --table @/page.html"));
        assertTrue(errors().contains("is an input or another output; expected another file"), errors());
        assertEquals(2, command("campaign @/plan.xml --out @/whole"));
        assertTrue(errors().startsWith("faultline: @/whole"), errors());
    }
}
