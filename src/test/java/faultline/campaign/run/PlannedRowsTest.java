package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Rows of real runs with every outcome, and what other programs may make of them. */
class PlannedRowsTest {

    private static final String ELEMENTS =
            """
            <worlds><scenario file="room.xml" name="the room, again"/></worlds>
            <seeds first="7"/>
            <set attribute="@duration" value="120 2"/>
            <set attribute="controller/@diagnosis" value="on off"/>
            <set attribute="robot/@speed" value="0.2..0.3"/>
            <set attribute="world/circle[pole]/@x" value="2 0.6"/>
            <set attribute="world/circle[pole]/@y" value="0.5 1.2"/>
            <faults>
              <healthy/>
              <fault sensor="front" kind="stuck" value="0.9" at="1"/>
              <fault sensor="left" kind="off" at="1"/>
            </faults>
            <masks>
              <mask on="front front-left left rear-left rear rear-right right front-right"/>
              <mask on="rear"/>
            </masks>
            """;

    @TempDir
    static Path made;

    @TempDir
    Path folder;

    private static CampaignPlan plan;
    private static List<String> names;
    private static List<List<String>> rows;

    @BeforeAll
    static void makeTheCampaign() throws Exception {
        plan = SamplePlan.read(SamplePlan.text("", ELEMENTS));
        new CampaignRunner(plan, new CampaignFolder(made), Shard.ALL, 2).run(false, (done, runs) -> {}, () -> false);
        List<String> lines = Files.readAllLines(made.resolve("runs.csv"));
        names = Csv.cells(lines.get(0));
        rows = lines.stream().skip(1).map(Csv::cells).toList();
    }

    /** Returns the error in a row that is read as that of the run of another one. */
    private static String problem(List<String> cells, List<String> run) {
        return new PlannedRows(plan)
                .findProblem(cells, Long.parseLong(run.get(0)))
                .map(Object::toString)
                .orElse("");
    }

    /** Returns the first row of an outcome in which the diagnosis finds the fault, if there is one. */
    private static List<String> row(String outcome) {
        List<List<String>> found = rows.stream()
                .filter(row -> row.get(names.indexOf("outcome")).equals(outcome))
                .toList();
        return found.stream()
                .filter(row -> !row.get(names.indexOf("detection_delay_s")).isEmpty())
                .findFirst()
                .orElseGet(() -> found.get(0));
    }

    private static List<String> changed(List<String> row, String column, String text) {
        List<String> cells = new ArrayList<>(row);
        cells.set(names.indexOf(column), text);
        return cells;
    }

    @Test
    void everyRowThatTheProgramWritesIsGood() {
        for (List<String> row : rows) {
            assertEquals("", problem(row, row), row::toString);
        }
        Set<String> outcomes =
                rows.stream().map(row -> row.get(names.indexOf("outcome"))).collect(Collectors.toSet());
        assertEquals(Set.of("collided", "lost", "stopped", "undecided", "carried_on", "broken"), outcomes);
        assertTrue(!row("carried_on").get(names.indexOf("detection_delay_s")).isEmpty(), "a fault is detected");
    }

    /** Only what a robot touched, and why a run failed, can be any text. */
    @ParameterizedTest
    @CsvSource({"collided, collided_with", "lost, -", "stopped, -", "undecided, -", "carried_on, -", "broken, failure"})
    void noOtherTextIsAcceptedInAColumn(String outcome, String free) {
        for (String column : names) {
            String problem = problem(changed(row(outcome), column, "?"), row(outcome));
            assertEquals(
                    !column.equals(free), problem.startsWith(column + " is \"?\"; expected "), column + ": " + problem);
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            textBlock =
                    """
                    carried_on | block                | 1        | "0"
                    carried_on | world                | room     | "the room, again"
                    carried_on | seed                 | 8        | "7"
                    carried_on | duration_s           | 2        | "120"
                    carried_on | controller_diagnosis | maybe    | "on"
                    carried_on | sensors_on           | rear     | "front front-left left rear-left rear rear-right right front-right"
                    carried_on | outcome              | lost     | "0" with the outcome lost
                    stopped    | carried_on           | 1        | "0" with the outcome stopped
                    stopped    | collided             | 1        | "0" with the outcome stopped
                    carried_on | collision_time_s     | 3        | nothing with the outcome carried_on
                    collided   | collision_time_s     | ``       | a value with the outcome collided
                    collided   | collision_time_s     | 121      | at most 120, the value of simulated_s
                    collided   | collided_with        | ``       | a value with the outcome collided
                    carried_on | collided_with        | pole     | nothing with the outcome carried_on
                    carried_on | wall_share           | 0.7      | at least 0.8 with the outcome carried_on
                    carried_on | wall_share           | 1.0001   | a number from 0 to 1 or nothing
                    carried_on | laps                 | -1       | a number of at least 0 or nothing
                    carried_on | laps                 | 1e999    | a number of at least 0 or nothing
                    carried_on | laps                 | ``       | a value as in wall_share
                    carried_on | clock_start_s        | ``       | a value as in wall_share
                    carried_on | coverage             | NaN      | a number from 0 to 1 or nothing
                    carried_on | coverage             | 1.5      | a number from 0 to 1 or nothing
                    carried_on | distance_rms_m       | Infinity | a number of at least 0 or nothing
                    carried_on | final_state          | FALL     | one of ALIGN, DRIVE, FOLLOW, MEASURE, NONE, ROUND, SEARCH, STOP, TURN
                    carried_on | final_rung           | FOUR     | one of ALL, ONE, REDUCED, STOP, THREE, TWO or nothing
                    carried_on | detection_delay_s    | 100000   | at most 120, the value of simulated_s
                    carried_on | detection_view_s     | ``       | a value as in detection_delay_s
                    carried_on | detection_error_m    | ``       | a value as in detection_delay_s
                    carried_on | false_alarms         | ``       | a value as in detection_delay_s
                    carried_on | false_alarms         | 0.5      | a whole number of at least 0 or nothing
                    carried_on | trajectory_hash      | zz       | 16 of the digits 0 to 9 and a to f
                    carried_on | trajectory_hash      | ``       | a value with the outcome carried_on
                    carried_on | failure              | boom     | nothing with the outcome carried_on
                    broken     | coverage             | 0.5      | nothing with the outcome broken
                    """)
    void aCellThatIsNotOfItsRunIsReported(String outcome, String column, String text, String expected) {
        String named = column.equals("outcome") ? "carried_on is \"1\"" : column + " is \"" + text + "\"";
        assertEquals(named + "; expected " + expected, problem(changed(row(outcome), column, text), row(outcome)));
    }

    @Test
    void theStatesOfOtherControllersAreNotKnown() throws Exception {
        String room = SamplePlan.ROOM.replace(
                "</scenario>",
                "<controller type=\"recorded\" ticks=\"100\"><decisions>1,1*100</decisions></controller></scenario>");
        CampaignPlan recorded = SamplePlan.read(
                SamplePlan.text(
                        "", "<worlds><scenario file=\"room.xml\"/></worlds><set attribute=\"@duration\" value=\"1\"/>"),
                room);
        new CampaignRunner(recorded, new CampaignFolder(folder), Shard.ALL, 1)
                .run(false, (done, runs) -> {}, () -> false);
        List<String> lines = Files.readAllLines(folder.resolve("runs.csv"));
        List<String> header = Csv.cells(lines.get(0));
        List<String> cells = Csv.cells(lines.get(1));
        cells.set(header.indexOf("final_state"), "FALL");
        assertEquals(Optional.empty(), new PlannedRows(recorded).findProblem(cells, 0));
    }

    @Test
    void aCampaignWithARowOfAnotherPlanIsNeitherContinuedNorMerged() throws Exception {
        CampaignFolder part = new CampaignFolder(folder.resolve("part"));
        CampaignRunner runner = new CampaignRunner(plan, part, Shard.ALL, 1);
        runner.run(false, (done, runs) -> {}, () -> done(part) > 3);
        List<String> lines = new ArrayList<>(Files.readAllLines(made.resolve("runs.csv")));
        lines.set(2, lines.get(2).replace("the room", "no room"));
        Files.write(part.runs(), lines);
        byte[] changed = Files.readAllBytes(part.runs());
        String problem = part.runs() + ":3: world is \"no room, again\"; expected \"the room, again\"";
        IOException resumed = assertThrows(IOException.class, () -> runner.run(true, (done, runs) -> {}, () -> false));
        assertTrue(resumed.getMessage().startsWith(problem + "; restore the table"), resumed.getMessage());
        IOException merged = assertThrows(IOException.class, () -> new CampaignMerge(List.of(part))
                .writeTo(new CampaignFolder(folder.resolve("merged"))));
        assertEquals(problem, merged.getMessage());
        assertArrayEquals(changed, Files.readAllBytes(part.runs()));
    }

    private static int done(CampaignFolder part) {
        try {
            return Files.readAllLines(part.runs()).size();
        } catch (IOException e) {
            return 0;
        }
    }
}
