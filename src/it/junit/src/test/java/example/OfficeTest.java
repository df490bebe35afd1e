package example;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.scenario.Scenario;
import faultline.scenario.ScenarioRun;
import java.util.List;
import org.junit.jupiter.api.Test;

class OfficeTest {

    @Test
    void theRobotFollowsTheWallsOfTheOffice() throws Exception {
        ScenarioRun run = Scenario.loadShipped("office.xml").run();
        assertEquals(List.of(), run.unmetExpectations());
        assertTrue(run.collision().isEmpty());
    }
}
