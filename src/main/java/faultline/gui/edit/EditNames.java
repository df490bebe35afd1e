package faultline.gui.edit;

import faultline.gui.text.Messages;
import faultline.gui.text.MotorFaultText;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Obstacle;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Names edits for menus, from each command and its inverse. */
final class EditNames implements Command.Visitor<EditNames.EditName> {

    private static final String SEVERAL = "edit.several";

    private final Command undo;

    private EditNames(CommandResult result) {
        this.undo = result.inverse().get(0);
    }

    /**
     * The name of one command's edit.
     *
     * @param key the key of the message for one such command
     * @param severalKey the key of the message for several such commands
     * @param subject the id of what is edited
     */
    record EditName(String key, String severalKey, String subject) {
        EditName(String key, String subject) {
            this(key, SEVERAL, subject);
        }
    }

    static String nameOf(List<CommandResult> results) {
        CommandResult first = results.get(0);
        EditName name = first.command().accept(new EditNames(first));
        if (results.size() == 1) {
            return Messages.get(name.key(), name.subject());
        }
        boolean alike = results.stream()
                .allMatch(
                        result -> result.command().getClass() == first.command().getClass());
        return Messages.get(alike ? name.severalKey() : SEVERAL, Integer.toString(results.size()));
    }

    @Override
    public EditName visit(Command.SwitchSensor command) {
        return new EditName(command.on() ? "edit.switchOn" : "edit.switchOff", command.sensor());
    }

    @Override
    public EditName visit(Command.ConfigureSensor command) {
        return new EditName(sensorKey(command.sensor()), command.sensor().id());
    }

    private String sensorKey(SensorSpec now) {
        SensorSpec before = undo instanceof Command.ConfigureSensor back ? back.sensor() : now;
        Map<String, SensorSpec> single = new LinkedHashMap<>();
        single.put("edit.range", before.withRange(now.range()));
        single.put("edit.cone", before.withCone(now.cone()));
        single.put("edit.bearing", before.withBearing(now.bearing()));
        single.put("edit.mountPosition", before.withMountPosition(now.mountPosition()));
        single.put("edit.noise", before.withNoise(now.noise()));
        return single.entrySet().stream()
                .filter(change -> change.getValue().equals(now))
                .map(Map.Entry::getKey)
                .findFirst()
                .orElse("edit.tune");
    }

    @Override
    public EditName visit(Command.InjectFault command) {
        return new EditName("edit.fault", command.sensor());
    }

    @Override
    public EditName visit(Command.ClearFault command) {
        return new EditName("edit.repair", command.sensor());
    }

    @Override
    public EditName visit(Command.ClearFaults command) {
        return new EditName("edit.repair", "edit.repairSeveral", command.sensor());
    }

    @Override
    public EditName visit(Command.InjectMotorFault command) {
        return new EditName("edit.fault", MotorFaultText.motors(command.motor()));
    }

    @Override
    public EditName visit(Command.ClearMotorFault command) {
        return new EditName("edit.repair", MotorFaultText.motors(command.motor()));
    }

    @Override
    public EditName visit(Command.ClearMotorFaults command) {
        return new EditName("edit.repair", MotorFaultText.motors(command.motor()));
    }

    @Override
    public EditName visit(Command.MoveObstacle command) {
        boolean turns = undo instanceof Command.MoveObstacle back
                && back.pose().heading() != command.pose().heading();
        return turns
                ? new EditName("edit.turn", "edit.turnSeveral", command.obstacle())
                : new EditName("edit.move", "edit.moveSeveral", command.obstacle());
    }

    @Override
    public EditName visit(Command.PlaceObstacle command) {
        Obstacle now = command.obstacle();
        if (!(undo instanceof Command.PlaceObstacle back)) {
            return new EditName("edit.add", "edit.addSeveral", now.id());
        }
        String key = changesOnlySpeed(back.obstacle(), now) ? "edit.motionSpeed" : "edit.change";
        return new EditName(key, "edit.changeSeveral", now.id());
    }

    private static boolean changesOnlySpeed(Obstacle before, Obstacle now) {
        return before.isMoving()
                && !before.motion().equals(now.motion())
                && before.motion().withSpeed(now.motion().speed()).equals(now.motion());
    }

    @Override
    public EditName visit(Command.RemoveObstacle command) {
        return new EditName("edit.remove", "edit.removeSeveral", command.obstacle());
    }

    @Override
    public EditName visit(Command.SetPlatform command) {
        boolean speed = undo instanceof Command.SetPlatform back && back.speed() != command.speed();
        return new EditName(speed ? "edit.speed" : "edit.platform", "");
    }

    @Override
    public EditName visit(Command.ConfigureController command) {
        return new EditName("edit.controller", "");
    }
}
