package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DidYouMeanTest {

    private static final List<String> NAMES = List.of("front", "front-left", "left", "rear");

    @ParameterizedTest
    @CsvSource({
        "frnt, front",
        "fornt, front",
        "FRONT, front",
        "frontt, front",
        "front_left, front-left",
        "lefft, left",
        "raer, rear"
    })
    void aNearNameIsSuggested(String given, String meant) {
        assertEquals("; did you mean \"" + meant + "\"?", DidYouMean.hint(given, NAMES));
    }

    @ParameterizedTest
    @CsvSource({"x", "sonar", "''", "bottom-right", "frxxt"})
    void aDistantNameIsNotSuggested(String given) {
        assertEquals("", DidYouMean.hint(given, NAMES));
    }

    @Test
    void aNameOfMoreThanSixtyLettersHasNoSuggestion() {
        List<String> long60 = List.of("n".repeat(60));
        assertEquals(Optional.of(long60.get(0)), DidYouMean.nearest("n".repeat(59) + "m", long60));
        assertEquals(Optional.empty(), DidYouMean.nearest("n".repeat(60) + "m", long60));
    }

    @ParameterizedTest
    @CsvSource({
        "'', '', 0",
        "abc, abc, 0",
        "abc, abd, 1",
        "abc, acb, 1",
        "abc, ab, 1",
        "abc, xabc, 1",
        "xb, bc, 2",
        "kitten, sitting, 3"
    })
    void editDistanceCountsChanges(String a, String b, int changes) {
        assertEquals(changes, DidYouMean.editDistance(a, b));
    }

    @ParameterizedTest
    @CsvSource({"abcdef, abcdxy, true", "abcdef, abcxyz, false", "abcdefghi, abcdefxyz, true", "abcde, abcxy, false"})
    void oneChangeInThreeLettersIsNear(String known, String given, boolean near) {
        assertEquals(near, DidYouMean.nearest(given, List.of(known)).isPresent());
    }

    @ParameterizedTest
    @CsvSource({"on, no, true", "ir, it, true", "on, xy, false", "x, y, true", "of, off, true", "a, abc, false"})
    void ofAShorterNameOneChangeIsNear(String given, String known, boolean near) {
        assertEquals(near, DidYouMean.nearest(given, List.of(known)).isPresent());
    }

    @Test
    void ofNamesThatAreEquallyNearTheFirstIsSuggested() {
        assertEquals(Optional.of("left"), DidYouMean.nearest("lefx", List.of("right", "left", "lefs")));
    }

    /** A file may have a hundred unknown ids, each of which is compared with thousands of others. */
    @ParameterizedTest
    @CsvSource({"60, 250, true", "60, 350, false", "6, 15000, true", "6, 25000, false"})
    void onlyAMillionPairsOfLettersAreCompared(int length, int others, boolean reached) {
        String given = "a".repeat(length);
        List<String> known = new ArrayList<>(IntStream.range(0, others)
                .mapToObj(i -> String.format("b%0" + (length - 1) + "d", i))
                .toList());
        known.add(given);
        assertEquals(reached, DidYouMean.nearest(given, known).isPresent());
    }
}
