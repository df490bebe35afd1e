package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import faultline.io.Message;
import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.NumberRange;
import faultline.scenario.xml.ProblemKind;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.ScenarioLimits;
import faultline.scenario.xml.SourceLocation;
import faultline.scenario.xml.XmlElement;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Points are read to the same bits, and refused with the same messages, as {@link PointsReference} reads them. */
class RingScannerTest {

    private static final String[] NUMBERS = {
        "0",
        "-0",
        "-0.0",
        "5",
        "5.",
        ".5",
        "-.5",
        "+5",
        "1e3",
        "1E-2",
        "1e-400",
        "100000",
        "-100000",
        "100000.0",
        "99999.99999999999999",
        "00000000000000000001",
        "0.123456789012345",
        "12345.6789012345",
        "0.1000000000000000055511151231257827",
        "41.125",
        "-17.625"
    };
    private static final String[] NO_NUMBERS = {
        "",
        "-",
        ".",
        "-.",
        "--5",
        "5-",
        "1.2.3",
        "1e",
        "1e99999",
        "NaN",
        "Infinity",
        "0x1",
        "5d",
        "\u0661",
        "\u00bd",
        "\ud83d\ude00",
        "5\u0141",
        "?",
        "5;",
        "1\u00a0",
        "1\u0000",
        "1\u000b",
        "-100001",
        "100000.00000000001",
        "123456789012345"
    };

    /** What is returned in place of invalid points. */
    private static final List<List<Double>> PLACEHOLDER = List.of(List.of(0.0, 0.0, 1.0, 0.0, 0.0, 1.0));

    private static final String[] BLANKS = {" ", "  ", "\n", "\t", "\r\n", "\f", " \t"};

    private final SplittableRandom random = new SplittableRandom(83);

    private String choice(String... options) {
        return options[random.nextInt(options.length)];
    }

    private boolean rarely() {
        return random.nextInt(150) == 0;
    }

    private String number() {
        if (rarely()) {
            return choice(NO_NUMBERS);
        }
        return random.nextInt(3) == 0 ? choice(NUMBERS) : String.valueOf(random.nextInt(-99999, 99999) / 1000.0);
    }

    private String pair() {
        return number() + (rarely() ? choice("", ";", " ,", ",,", "|") : ",") + number();
    }

    private String text() {
        StringBuilder text = new StringBuilder(random.nextBoolean() ? "" : choice(BLANKS));
        for (int ring = random.nextInt(1, 5); ring > 0; ring--) {
            for (int i = rarely() ? random.nextInt(3) : random.nextInt(3, 8); i > 0; i--) {
                text.append(pair()).append(i == 1 && random.nextBoolean() ? "" : choice(BLANKS));
            }
            text.append(ring == 1 ? choice("", "", "", "|") : choice("|", " | ", "|\n", "||".repeat(rarely() ? 1 : 0)));
        }
        return text.toString();
    }

    /** Reads the attribute of a plan or, with at least some points, of another shape, and compares all results. */
    private static boolean isReadAsByReference(String text, int least, int most) {
        boolean isPlan = least == 0;
        Problems problems = new Problems("f.xml");
        XmlElement node = new XmlElement(
                isPlan ? "plan" : "wall", new SourceLocation(2, 7), Map.of("points", text), List.of(), "");
        PointListReader reader = new PointListReader(node, new AttributeReader(node, problems), problems, most);
        List<List<Vector2>> rings = isPlan ? reader.plan().rings() : List.of(reader.points(least));
        PointsReference expected = isPlan
                ? PointsReference.ofPlan(text, Math.max(3, most))
                : PointsReference.ofPoints(text, least, Math.max(least, most));
        Message allowed = isPlan
                ? Allowed.RINGS.with(NumberRange.COORDINATE.rule())
                : Allowed.POINTS.with(least, NumberRange.COORDINATE.rule());
        assertEquals(problems("f.xml", expected, node, allowed), problems(problems), text);
        assertEquals(expected.problems().isEmpty() ? expected.rings() : PLACEHOLDER, coordinates(rings), text);
        return expected.problems().isEmpty();
    }

    private static List<String> problems(String file, PointsReference expected, XmlElement node, Message allowed) {
        Problems problems = new Problems(file);
        AttributeReader fields = new AttributeReader(node, problems);
        for (String value : expected.problems()) {
            if (value.equals("too many")) {
                problems.add(node, ProblemKind.TOO_MANY_POINTS.with("points", node.name(), ScenarioLimits.MAX_PARTS));
            } else {
                fields.report("points", value, allowed);
            }
        }
        return problems(problems);
    }

    private static List<String> problems(Problems problems) {
        try {
            problems.throwIfAny();
            return List.of();
        } catch (ScenarioException e) {
            return e.problems().stream().map(Object::toString).toList();
        }
    }

    /** A list of doubles tells zeros of different signs apart. */
    private static List<List<Double>> coordinates(List<List<Vector2>> rings) {
        List<List<Double>> all = new ArrayList<>();
        for (List<Vector2> ring : rings) {
            all.add(ring.stream().flatMap(p -> Stream.of(p.x(), p.y())).toList());
        }
        return all;
    }

    @Test
    void randomTextsAreReadAsByTheReference() {
        int valid = 0;
        for (int trial = 0; trial < 30_000; trial++) {
            int least = random.nextInt(4);
            int most = random.nextInt(4) == 0 ? random.nextInt(20) : 1000;
            valid += isReadAsByReference(text(), least, most) ? 1 : 0;
        }
        assertTrue(valid > 5_000 && valid < 20_000, valid + " of 30000 were valid");
    }

    @Test
    void everyFormOfANumberIsReadInEveryPlace() {
        for (String number : Stream.of(NUMBERS, NO_NUMBERS).flatMap(Stream::of).toList()) {
            for (String pair : List.of(number + ",1", "1," + number, number + "," + number, number)) {
                isReadAsByReference("0,0 " + pair + " 1,1", 3, 1000);
                isReadAsByReference("0,0 1,1 " + pair, 3, 1000);
                isReadAsByReference("0,0 1,1 2,2|" + pair + " 1,1 2,3|4,4 5,5 " + pair, 0, 1000);
            }
        }
    }

    @Test
    void aPairWithABrokenCharacterIsReportedAsItIs() {
        for (String pair : List.of("1,\u0662", "1,\ud83d\ude00", "\ud83d\ude00,\ud83d\ude00", "1,2\u00ff")) {
            assertFalse(isReadAsByReference("0,0 1,1 2,2 | 3,3 4,4 " + pair + " | 1,1", 0, 1000));
        }
    }
}
