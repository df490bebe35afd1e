package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** The lines that Python writes about an exception. */
class PythonTracebackTest {

    @Test
    void theInnermostLineOfTheUsersProgramIsFound() {
        List<String> lines = List.of(
                "Traceback (most recent call last):",
                "  File \"/home/a/robot.py\", line 9, in <module>",
                "    faultline.drive_with(decide)",
                "  File \"/home/a/faultline.py\", line 200, in drive_with",
                "  File \"C:\\robots\\gains.py\", line 3, in decide",
                "  File \"/usr/lib/python3.12/random.py\", line 7, in choice",
                "  File \"<frozen os>\", line 1, in x",
                "NameError: gain");
        assertEquals(Optional.of(new PythonTraceback.ProgramLine("gains.py", "3")), PythonTraceback.findOwnLine(lines));
        assertEquals(
                Optional.of(new PythonTraceback.ProgramLine("robot.py", "9")),
                PythonTraceback.findOwnLine(List.of(lines.get(1), lines.get(2), lines.get(3), lines.get(7))));
        assertEquals(Optional.empty(), PythonTraceback.findOwnLine(lines.subList(6, 8)));
    }

    @Test
    void aTracebackBeforeOtherLinesIsNotTheReason() {
        List<String> lines = List.of(
                "Traceback (most recent call last):",
                "  File \"robot.py\", line 4, in <module>",
                "    1 / 0",
                "ZeroDivisionError: division by zero",
                "the model of the battery is missing");
        assertEquals(Optional.empty(), PythonTraceback.findOwnLine(lines));
        assertEquals(
                Optional.of(new PythonTraceback.ProgramLine("robot.py", "4")),
                PythonTraceback.findOwnLine(lines.subList(0, 4)));
    }

    @Test
    void furtherLinesFollowTheException() {
        List<String> lines = List.of(
                "starting",
                "Traceback (most recent call last):",
                "  File \"robot.py\", line 4, in <module>",
                "    raise ValueError(text)",
                "ValueError: line one",
                "  File \"data.py\", line 7",
                "line three");
        assertEquals(lines.subList(0, 5), PythonTraceback.beginning(lines));
        assertEquals(lines.subList(0, 5), PythonTraceback.beginning(lines.subList(0, 5)));
        assertEquals(List.of(), PythonTraceback.beginning(lines.subList(2, 7)));
    }

    @Test
    void theExceptionOfAGroupIsThatOfAllItsMembers() {
        List<String> lines = List.of(
                "  + Exception Group Traceback (most recent call last):",
                "  |   File \"robot.py\", line 4, in <module>",
                "  |     raise group",
                "  | ExceptionGroup: many (1 sub-exception)",
                "    | Traceback (most recent call last):",
                "    |   File \"robot.py\", line 9, in member",
                "    | ValueError: a");
        List<String> beginning = PythonTraceback.beginning(lines);
        assertEquals("ExceptionGroup: many (1 sub-exception)", beginning.get(beginning.size() - 1));
        assertEquals(
                Optional.of(new PythonTraceback.ProgramLine("robot.py", "4")), PythonTraceback.findOwnLine(beginning));
    }
}
