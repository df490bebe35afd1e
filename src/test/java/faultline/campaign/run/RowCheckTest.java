package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Rows that people and other programs may have changed. */
class RowCheckTest {

    private final Map<String, String> row = new HashMap<>();

    @BeforeEach
    void makeAGoodRow() {
        row.putAll(Map.of(
                "run",
                "7",
                "outcome",
                "lost",
                "carried_on",
                "0",
                "collided",
                "0",
                "wall_share",
                "0.5",
                "simulated_s",
                "9"));
    }

    private String problem() {
        return RowCheck.findProblem(column -> row.getOrDefault(column, ""))
                .map(Object::toString)
                .orElse("");
    }

    @ParameterizedTest
    @CsvSource({
        "run, 999999999999999999",
        "outcome, stopped",
        "carried_on, ''",
        "collided, 1",
        "wall_share, ''",
        "wall_share, 1.5E-7",
        "wall_share, ' +.5'",
        "simulated_s, 0",
        "simulated_s, 10000000"
    })
    void aCellThatARunCanHaveIsGood(String column, String cell) {
        row.put(column, cell);
        assertEquals("", problem());
    }

    @ParameterizedTest
    @CsvSource({
        "run, '', a whole number",
        "run, -1, a whole number",
        "run, 7.0, a whole number",
        "run, 1000000000000000000, a whole number",
        "outcome, '', 'one of carried_on, broken'",
        "carried_on, 1.0, '0, 1 or nothing'",
        "collided, true, '0, 1 or nothing'",
        "wall_share, half, a number or nothing",
        "wall_share, NaN, a number or nothing",
        "wall_share, 1E999, a number or nothing",
        "wall_share, 0.5d, a number or nothing",
        "simulated_s, '', a number from 0 to 10000000",
        "simulated_s, -1, a number from 0 to 10000000",
        "simulated_s, 10000000.1, a number from 0 to 10000000"
    })
    void aCellThatNoRunCanHaveIsReported(String column, String cell, String expected) {
        row.put(column, cell);
        String problem = problem().replace("collided, lost, stopped, undecided, ", "");
        assertEquals(column + " is \"" + cell + "\"; expected " + expected, problem);
    }

    /** The JDK reads the texts of the last line, but they are labels of faults, such as the first of four cases. */
    @Test
    void aNumberIsADecimalNumber() {
        assertEquals(0.25, RowCheck.number("0.25").getAsDouble());
        assertEquals(-1.5e-7, RowCheck.number(" -1.5E-7 ").getAsDouble());
        for (String text : List.of("", "NaN", "Infinity", "1e400", "half", "1d", "2f", "0x1p3")) {
            assertEquals(OptionalDouble.empty(), RowCheck.number(text), text);
        }
    }

    @Test
    void aRunThatFailedHasNoDuration() {
        row.put("simulated_s", "");
        row.put("outcome", Outcome.BROKEN);
        assertEquals("", problem());
    }
}
