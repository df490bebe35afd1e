package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.io.JsonParser;
import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Traces of format 2, and compressed ones. */
class TraceFormatTest {

    private static final String SCENARIO =
            """
            <scenario xmlns="urn:faultline:scenario:1" name="Traced" duration="26" seed="7">
              <world width="5" height="4"/>
              <robot x="2" y="2" heading="60"><motor timeConstant="0.08" leftScale="1.03"/></robot>
              <timeline>
                <fault at="12" sensor="right" kind="stuck" value="0.3"/>
                <fault at="13" sensor="right" kind="noise" value="0.02" until="15"/>
                <fault at="14" sensor="front" kind="off"/>
                <fault at="15" motor="left" kind="weak" value="0.9"/>
              </timeline>
            </scenario>
            """;

    @TempDir
    Path folder;

    private List<String[]> trace(String name, String... options) throws IOException {
        Path scenario = Files.writeString(folder.resolve("traced.xml"), SCENARIO);
        List<String> arguments = new ArrayList<>(List.of(
                "run", scenario.toString(), "--trace", folder.resolve(name).toString()));
        arguments.addAll(List.of(options));
        PrintStream sink = new PrintStream(new ByteArrayOutputStream(), true, StandardCharsets.UTF_8);
        assertEquals(0, new CommandLine(new CommandOutput(sink, sink)).run(arguments.toArray(String[]::new)));
        try (InputStream in = Files.newInputStream(folder.resolve(name));
                BufferedReader text = new BufferedReader(new InputStreamReader(
                        name.endsWith(".gz") ? new GZIPInputStream(in) : in, StandardCharsets.UTF_8))) {
            return text.lines().map(line -> line.split(",", -1)).toList();
        }
    }

    private static int column(List<String[]> rows, String name) {
        int index = Arrays.asList(rows.get(0)).indexOf(name);
        assertTrue(index >= 0, name);
        return index;
    }

    private static double number(List<String[]> rows, int row, String column) {
        return Double.parseDouble(rows.get(row)[column(rows, column)]);
    }

    private static String word(List<String[]> rows, double time, String column) {
        return rows.get(1 + (int) Math.round(time / 0.01))[column(rows, column)];
    }

    @Test
    void everyColumnHoldsNumbersOrWords() throws IOException {
        List<String[]> rows = trace("two.csv", "--trace-format", "2");
        assertEquals(2602, rows.size());
        List<String> words = List.of("state", "collided", "rung", "left_motor_faults", "right_motor_faults");
        for (int i = 0; i < rows.get(0).length; i++) {
            String name = rows.get(0)[i];
            if (!words.contains(name) && !name.matches(".*\\.(faults|trust|finding)")) {
                for (String[] row : rows.subList(1, rows.size())) {
                    assertTrue(row[i].isEmpty() || Double.isFinite(Double.parseDouble(row[i])), name);
                }
            }
        }
    }

    @Test
    void faultsHealthAndRungAreThoseOfTheTimeline() throws IOException {
        List<String[]> rows = trace("two.csv", "--trace-format", "2");
        assertEquals("", word(rows, 11.0, "right.faults"));
        assertEquals("stuck=0.3", word(rows, 12.5, "right.faults"));
        assertEquals("stuck=0.3 noise=0.02", word(rows, 14.0, "right.faults"));
        assertEquals("stuck=0.3", word(rows, 16.0, "right.faults"));
        assertEquals("", word(rows, 14.9, "left_motor_faults"));
        assertEquals("weak=0.9", word(rows, 15.1, "left_motor_faults"));
        assertEquals("", word(rows, 15.1, "right_motor_faults"));
        assertEquals("1", word(rows, 13.9, "front.answers"));
        assertEquals("0", word(rows, 14.1, "front.answers"));
        assertEquals("", word(rows, 14.1, "front.reading"));
        assertEquals("ALL", word(rows, 1, "rung"));
        assertFalse(word(rows, 18.0, "rung").equals("ALL"));
        assertEquals("distrusted", word(rows, 18.0, "front.trust"));
        assertEquals("off", word(rows, 18.0, "front.finding"));
        assertEquals("trusted", word(rows, 1, "front.trust"));
        assertEquals("none", word(rows, 1, "front.finding"));
        assertEquals("0.0", word(rows, 1, "front.evidence"));
        assertEquals("1.0", word(rows, 18.0, "right.evidence"));
    }

    /** The true wheels follow the volts by the closed form of a first-order lag; the left side is 3 % faster. */
    @Test
    void voltsMoveTheWheels() throws IOException {
        List<String[]> rows = trace("two.csv", "--trace-format", "2");
        double decay = Math.exp(-0.01 / 0.08);
        for (int i = 2; i < 900; i++) {
            for (String side : List.of("left", "right")) {
                double before = number(rows, i - 1, side + "_v");
                double goal = 0.1 * (side.equals("left") ? 1.03 : 1) * number(rows, i, side + "_volts");
                assertEquals(goal + (before - goal) * decay, number(rows, i, side + "_v"), 1e-12, side + " " + i);
            }
            double left = number(rows, i, "left_v");
            double right = number(rows, i, "right_v");
            assertEquals((left + right) / 2, number(rows, i, "v"), 1e-12);
            assertEquals((right - left) / 0.18, number(rows, i, "omega"), 1e-9);
        }
    }

    @Test
    void telemetryIsThatOfTheFollower() throws IOException {
        List<String[]> rows = trace("two.csv", "--trace-format", "2");
        int follow = 1;
        while (!word(rows, (follow - 1) * 0.01, "state").equals("FOLLOW")) {
            follow++;
        }
        int align = follow - 1;
        double f3 = number(rows, align, "t_f3_s");
        double f4 = number(rows, align, "t_f4_s");
        assertTrue(f3 > 0 && f3 < f4, f3 + " " + f4);
        assertEquals((f4 - f3) / 2, number(rows, align, "t_p_s"), 0.2, "t_p is t_D / 2 and the lag of the motors");
        assertEquals(0.25, number(rows, follow + 20, "wanted_m"));
        // The decision that acts in a tick was made on the readings of the tick before.
        assertEquals(number(rows, follow + 19, "left.reading"), number(rows, follow + 20, "measured_m"));
        // At first there is no change of the distance to control; the terms together turn the robot.
        assertTrue(number(rows, follow, "p_rad_s") > 0, "the wall is too far away");
        assertEquals(0, number(rows, follow, "d_rad_s"), 1e-12);
        assertTrue(number(rows, follow + 20, "d_rad_s") < 0, "the robot approaches it");
        for (int row : new int[] {follow, follow + 20}) {
            double turnRate = 0.1 * (number(rows, row, "right_volts") - number(rows, row, "left_volts")) / 0.18;
            assertEquals(turnRate, number(rows, row, "p_rad_s") + number(rows, row, "d_rad_s"), 1e-9);
        }
    }

    @Test
    void theTermsAreEmptyWhereTheDistanceIsNotControlled() throws IOException {
        List<String[]> rows = trace("two.csv", "--trace-format", "2");
        List<String> empty = List.of("SEARCH", "TURN", "MEASURE", "ALIGN");
        Set<String> afterFollow = new HashSet<>();
        for (String[] row : rows.subList(2, rows.size())) {
            String state = row[column(rows, "state")];
            for (String term : List.of("p_rad_s", "d_rad_s")) {
                String value = row[column(rows, term)];
                if (empty.contains(state)) {
                    assertEquals("", value, state);
                } else if (state.equals("FOLLOW") && row[column(rows, "rung")].equals("ALL")) {
                    assertFalse(value.isEmpty(), term);
                }
            }
            if (state.equals("FOLLOW") || !afterFollow.isEmpty()) {
                afterFollow.add(state);
            }
        }
        assertTrue(afterFollow.contains("TURN"), afterFollow::toString);
    }

    @Test
    void formatOneIsTheDefaultAndTheSameColumns() throws IOException {
        List<String[]> one = trace("one.csv");
        List<String[]> two = trace("two.csv", "--trace-format", "2");
        assertEquals(27, one.get(0).length);
        assertEquals("off", word(one, 14.1, "front.reading"));
        for (String name : one.get(0)) {
            if (!name.startsWith("front.") && !name.equals("t")) {
                for (int row = 1; row < one.size(); row += 100) {
                    assertEquals(one.get(row)[column(one, name)], two.get(row)[column(two, name)], name);
                }
            }
        }
        assertFalse(Files.exists(folder.resolve("one.csv.json")));
    }

    @Test
    void timesOfFormatTwoAreExactMultiplesOfTheTick() throws IOException {
        List<String[]> one = trace("one.csv");
        List<String[]> two = trace("two.csv", "--trace-format", "2");
        int rounded = 0;
        for (int tick = 0; tick <= 2600; tick++) {
            String exact = BigDecimal.valueOf(tick, 2).stripTrailingZeros().toPlainString();
            assertEquals(exact.contains(".") ? exact : exact + ".0", two.get(1 + tick)[1]);
            assertEquals(Double.toString(tick * 0.01), one.get(1 + tick)[1], "format 1 stays as it was");
            rounded += one.get(1 + tick)[1].equals(two.get(1 + tick)[1]) ? 0 : 1;
        }
        assertTrue(rounded > 100, rounded + " times have a rounding error in format 1");
    }

    @Test
    void aTraceIsCompressedAlsoIfItsEndingIsInCapitals() throws Exception {
        trace("PACKED.CSV.GZ", "--trace-format", "2");
        try (InputStream in = new GZIPInputStream(Files.newInputStream(folder.resolve("PACKED.CSV.GZ")))) {
            assertEquals('t', in.read(), "the first column is tick");
        }
    }

    @Test
    void aCompressedTraceHasTheSameRowsAndAHeaderFile() throws Exception {
        List<String[]> plain = trace("plain.csv", "--trace-format", "2");
        List<String[]> packed = trace("packed.csv.gz", "--trace-format", "2");
        assertEquals(
                plain.stream().map(row -> String.join(",", row)).toList(),
                packed.stream().map(row -> String.join(",", row)).toList());
        Map<?, ?> header = (Map<?, ?>) JsonParser.parse(Files.readString(folder.resolve("packed.csv.gz.json")));
        byte[] hash = MessageDigest.getInstance("SHA-256").digest(SCENARIO.getBytes(StandardCharsets.UTF_8));
        assertEquals(String.format("%064x", new BigInteger(1, hash)), header.get("scenario_sha256"));
        assertEquals("faultline-trace-2", header.get("format"));
        assertEquals(
                Arrays.asList(plain.get(0)),
                ((List<?>) header.get("columns"))
                        .stream()
                                .map(column -> ((Map<?, ?>) column).get("name"))
                                .collect(Collectors.toList()));
    }

    @Test
    void anotherFormatIsRefused() {
        ByteArrayOutputStream errors = new ByteArrayOutputStream();
        PrintStream out = new PrintStream(errors, true, StandardCharsets.UTF_8);
        assertEquals(2, new CommandLine(new CommandOutput(out, out)).run("run", "a.xml", "--trace-format", "3"));
        assertTrue(errors.toString(StandardCharsets.UTF_8).contains("--trace-format is \"3\"; expected 1 or 2"));
    }
}
