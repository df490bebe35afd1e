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

    @Test
    void aThingFartherOffIsNotTakenForTheWallThatWasMet() {
        walk(new Room("an alcove's corner met on the right, while another one was in sight on the left",
                List.of(new Vec(2.5, 3), new Vec(4.753247426978839, 3), new Vec(4.753247426978839, 2.399349026972408),
                        new Vec(6.0593914203299635, 2.399349026972408), new Vec(6.0593914203299635, 3), new Vec(7.5, 3),
                        new Vec(7.5, 4.045928299591763), new Vec(6.758685178445701, 4.045928299591763),
                        new Vec(6.758685178445701, 5.619732645919262), new Vec(7.5, 5.619732645919262), new Vec(7.5, 7),
                        new Vec(6.195431392070615, 7), new Vec(6.195431392070615, 7.629318262327242),
                        new Vec(3.425225946760067, 7.629318262327242), new Vec(3.425225946760067, 7), new Vec(2.5, 7),
                        new Vec(2.5, 6.015831646516501), new Vec(1.775648359259078, 6.015831646516501),
                        new Vec(1.775648359259078, 4.839435663561796), new Vec(2.5, 4.839435663561796)),
                new Pose(3.46827471793019, 6.0415720278356835, 5.573780412896247)));
    }
}
