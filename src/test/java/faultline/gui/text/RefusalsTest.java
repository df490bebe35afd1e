package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.Motion;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.World;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Whatever the world refuses, a Pole is told why in Polish. */
class RefusalsTest {

    private static final Pose ROBOT = new Pose(2, 2, 0);
    private static final Obstacle POLE = new Obstacle("pole", new ObstacleShape.Circle(0.1), new Pose(4, 2, 0));

    @AfterEach
    void speakEnglish() {
        Texts.speak(Language.ENGLISH);
    }

    private static List<Command> refused() {
        Motion way = new Motion(0.1, true, List.of(new Vec(4, 3)));
        return List.of(new Command.PutObstacle(POLE.at(ROBOT)), new Command.SetPlatform(9, 9, 0.3),
                new Command.PutObstacle(POLE.moving(Optional.of(way))), new Command.RemoveObstacle("sofa"),
                new Command.SwitchSensor("nose", true), new Command.ClearFault("left", new Fault.Dead()),
                new Command.PutObstacle(POLE.named(WorldSpec.ENCLOSURE)));
    }

    @ParameterizedTest
    @MethodSource("refused")
    void everyReasonOfTheWorldIsKnown(Command command) {
        String reason = new World(new WorldSpec(6, 4, true, 0, List.of()), RobotSpec.DEFAULT, ROBOT, 0.01, 1).apply(command).orElseThrow();
        assertEquals(reason, Refusals.text(reason), "in English as it is");
        Texts.speak(Language.POLISH);
        assertNotEquals(reason, Refusals.text(reason));
    }

    @Test
    void aReasonOfAnotherWordingStaysAsItIs() {
        assertEquals("the sky fell", Refusals.text("the sky fell"));
    }
}
