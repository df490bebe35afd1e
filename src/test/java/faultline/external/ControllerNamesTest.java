package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class ControllerNamesTest {

    @Test
    void aWordThatIsNearlyANameGetsAHint() {
        String hint = ControllerNames.hint("wall-folower").toString();
        assertTrue(hint.contains("wall-follower") && hint.contains("did you mean"), hint);
        assertEquals(hint, ControllerNames.hint(" wall-folower ").toString());
        String names = ControllerNames.hint("somethingelse").toString();
        assertTrue(names.contains("wall-follower, none") && !names.contains("did you mean"), names);
        for (String command : List.of("wall folower", "./none", "bin\\none")) {
            assertEquals("", ControllerNames.hint(command));
        }
    }

    @Test
    void aTypeIsWhatAScenarioFileNames() {
        assertEquals("none", ControllerNames.typeOf(new ControllerSpec.None()));
        assertEquals("drive", ControllerNames.typeOf(new ControllerSpec.Drive(1, 2)));
        assertEquals("wall-follower", ControllerNames.typeOf(ControllerSpec.WallFollowing.DEFAULT));
        assertEquals("extern", ControllerNames.typeOf(new ControllerSpec.Extern(0)));
        assertEquals("mine", ControllerNames.typeOf(new ControllerSpec.Provided("mine", 0, Map.of())));
        assertEquals("recorded", ControllerNames.typeOf(new ControllerSpec.Recorded(0.25, 0, List.of())));
    }

    @Test
    void theTypeOfAChosenControllerIsThatOfTheOneInTheFile() {
        ControllerSource source = new JarControllerSource("mine", List.of(), Map.of());
        assertEquals(
                "drive", ControllerNames.typeOf(new ControllerSpec.Chosen(new ControllerSpec.Drive(1, 2), source)));
    }
}
