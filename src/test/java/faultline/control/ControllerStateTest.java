package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ControllerStateTest {

    @ParameterizedTest
    @EnumSource
    void aNameOfTheWallFollowersIsItsState(FollowerState state) {
        assertSame(state, ControllerState.of(state.name()));
        assertThrows(IllegalArgumentException.class, () -> new ControllerState.Named(state.name()));
    }

    @Test
    void anyOtherTextIsAStateOfThatName() {
        ControllerState docking = ControllerState.of("docking, slowly");
        assertEquals("docking, slowly", docking.name());
        assertEquals("docking, slowly", docking.toString());
        assertEquals(docking, ControllerState.of("docking, slowly"));
    }

    @Test
    void aStateHasAName() {
        assertThrows(NullPointerException.class, () -> ControllerState.of(null));
    }
}
