package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ProcessAgeTest {

    @Test
    void theStartIsTheTwentySecondWordForAnyNameOfTheProcess() {
        String stat = "4711 (a) b (c) S 1 4711 4711 0 -1 4194560 100 0 0 0 5 1 0 0 20 0 "
                + "12 0 123450 99 7 18446744073709551615";
        assertEquals(0.75, ProcessAge.fromProcFiles(stat, "1235.25 2000.00\n"), 1e-9);
    }

    @Test
    void ageGrowsAndIsThatOfThisProcess() {
        double age = ProcessAge.seconds();
        assertTrue(age > 0 && age < 36_000, "" + age);
        assertTrue(ProcessAge.seconds() >= age);
    }
}
