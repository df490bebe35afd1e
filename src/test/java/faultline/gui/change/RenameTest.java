package faultline.gui.change;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Refusal;
import java.util.List;
import org.junit.jupiter.api.Test;

class RenameTest {

    @Test
    void theResultOfACommandAboutAnotherSensorIsNotCopied() {
        Rename rename = Rename.ofSensor("left", "port");
        CommandResult other = switched("right");
        assertSame(other, rename.rename(other));
        assertEquals(switched("port"), rename.rename(switched("left")));
        Command about = new Command.SwitchSensor("right", false);
        CommandResult refused =
                new CommandResult.Refused(1, about, new Refusal(Refusal.Reason.UNKNOWN_SENSOR, "right"));
        assertSame(refused, rename.rename(refused));
    }

    @Test
    void aDeletedSensorThatHadTheNewIdGetsTheEarlierOne() {
        Rename rename = Rename.ofSensor("left", "front");
        assertEquals(switched("left"), rename.rename(switched("front")));
        assertEquals(switched("front"), rename.inverse().rename(rename.rename(switched("front"))));
    }

    private static CommandResult switched(String sensor) {
        return new CommandResult.Executed(1, new Command.SwitchSensor(sensor, false), List.of());
    }
}
