package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.Walk.Manner;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Rooms that a follower has failed in, each with what it got wrong. */
class HardRoomsTest {

    private static void walk(Room room) {
        assertEquals(List.of(), Walk.round(room, Manner.USUAL).complaints(), room::toString);
    }

    @Test
    void theNoiseOfASharpTipIsForgottenAlongTheWallBehindIt() {
        walk(new Room("a tip of 20 degrees, after which the wall was taken for a circle for ever",
                List.of(new Vec(5.340961479213444, 3.8410933425001783), new Vec(4.527542712139212, 4.391170713486956),
                        new Vec(4.929428905779633, 6.534492955773434), new Vec(5.491560334238442, 5.4508379940946465)),
                new Pose(5.360883707450315, 8.983687104893772, -1.7609522807926352)));
    }

    @Test
    void aTipThatHasSlippedOutOfTheFrontConeIsNotRunInto() {
        walk(new Room("a wedge met tip first, while the front sensor saw its flank farther on",
                List.of(new Vec(4.791928440310932, 4.039230709632927), new Vec(3.5421238188201736, 5.084683644795077),
                        new Vec(6.117839495546213, 5.626455656734558)),
                new Pose(8.65633492034342, 6.6221020159895225, -2.798347125569634)));
    }
}
