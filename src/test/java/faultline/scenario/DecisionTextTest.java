package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Recorded decisions as text: two voltages and a whole, positive number of ticks. */
class DecisionTextTest {

    @ParameterizedTest
    @CsvSource({
        "'1,2', 1, 2, 1",
        "'-1.5,2e1*3', -1.5, 20, 3",
        "'0,-0*2e3', 0, -0.0, 2000",
        "'1,2*9007199254740992', 1, 2, 9007199254740992"
    })
    void aDecisionIsRead(String text, double left, double right, long ticks) {
        assertEquals(Optional.of(new DecisionText(left, right, ticks)), DecisionText.parse(text));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "1",
                "1,",
                ",2",
                "1,2*",
                "1,2*0",
                "1,2*-1",
                "1,2*1.5",
                "1,2*9007199254740993",
                "1*2,3",
                "1,2,3",
                "1e400,2",
                "1,-1e400",
                "NaN,2"
            })
    void whatIsNoDecisionIsNotRead(String text) {
        assertEquals(Optional.empty(), DecisionText.parse(text));
    }
}
