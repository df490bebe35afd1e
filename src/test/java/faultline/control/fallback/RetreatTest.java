package faultline.control.fallback;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.RandomRoom;
import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.sensor.FaultKind;
import faultline.world.Command;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Where the front sensor has missed a surface, the robot drives back before it turns. */
class RetreatTest {

    @Test
    void itEndsAfterTenCentimetresInEitherDirection() {
        Retreat retreat = new Retreat();
        assertFalse(retreat.isActive(), "at the beginning");
        retreat.start();
        retreat.advance(-0.06);
        assertTrue(retreat.isActive());
        retreat.advance(0.05);
        assertFalse(retreat.isActive());
    }

    @Test
    void itCanStartAgainAndEndEarlier() {
        Retreat retreat = new Retreat();
        retreat.start();
        retreat.advance(-0.09);
        retreat.start();
        retreat.advance(-0.09);
        assertTrue(retreat.isActive(), "from its beginning");
        retreat.end();
        assertFalse(retreat.isActive());
    }

    /** In these rooms a robot that turned at once touched the furniture ahead. */
    @ParameterizedTest
    @CsvSource({"2140092, 41.01", "2140203, 24.49", "2140035, 29.31", "2140533, 30.04"})
    void aRobotThatIsAlmostAtASurfaceDoesNotTouchIt(long room, double onset) {
        RandomRoom random = RandomRoom.ofSeed(room);
        Simulation simulation = new Simulation(
                SimulationSetup.of(random.world(), random.start())
                        .withController(ControllerSpec.WallFollowing.DEFAULT)
                        .withTimeline(List.of(new TimedCommand(
                                onset, new Command.InjectFault("front", FaultKind.STUCK_AT_LAST.createFault(0))))),
                ControllerMode.DIRECT);
        while (simulation.time() < onset + 15) {
            simulation.tick();
        }
        assertTrue(simulation.frame().snapshot().collisions().isEmpty());
    }
}
