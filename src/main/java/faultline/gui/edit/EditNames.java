package faultline.gui.edit;

import faultline.gui.text.Messages;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What edits are called in menus. */
final class EditNames {

    private EditNames() {}

    static String nameOf(List<ReversibleCommand> steps) {
        ReversibleCommand first = steps.get(0);
        if (steps.size() == 1) {
            return nameOf(first.redo(), first.undo());
        }
        boolean alike = steps.stream()
                .allMatch(step -> step.redo().getClass() == first.redo().getClass());
        return Messages.get(alike ? severalKey(first) : "edit.several", Integer.toString(steps.size()));
    }

    private static String severalKey(ReversibleCommand first) {
        if (first.redo() instanceof Command.MoveObstacle) {
            return isTurn(first.redo(), first.undo()) ? "edit.turnSeveral" : "edit.moveSeveral";
        }
        if (first.redo() instanceof Command.RemoveObstacle) {
            return "edit.removeSeveral";
        }
        if (first.redo() instanceof Command.ClearFaults) {
            return "edit.mendSeveral";
        }
        boolean adds =
                first.redo() instanceof Command.PlaceObstacle && first.undo().get(0) instanceof Command.RemoveObstacle;
        return adds
                ? "edit.addSeveral"
                : first.redo() instanceof Command.PlaceObstacle ? "edit.changeSeveral" : "edit.several";
    }

    private static String nameOf(Command redo, List<Command> undo) {
        if (redo instanceof Command.MoveObstacle move) {
            return Messages.get(isTurn(redo, undo) ? "edit.turn" : "edit.move", move.obstacle());
        }
        if (redo instanceof Command.PlaceObstacle put) {
            return Messages.get(
                    obstacleKey(put.obstacle(), undo.get(0)), put.obstacle().id());
        }
        if (redo instanceof Command.RemoveObstacle remove) {
            return Messages.get("edit.remove", remove.obstacle());
        }
        return redo instanceof Command.SetPlatform platform
                ? Messages.get(platformKey(platform, undo))
                : sensorEditName(redo, undo);
    }

    private static boolean isTurn(Command redo, List<Command> undo) {
        return redo instanceof Command.MoveObstacle move
                && undo.get(0) instanceof Command.MoveObstacle back
                && back.pose().heading() != move.pose().heading();
    }

    private static String obstacleKey(Obstacle now, Command undo) {
        boolean speed = undo instanceof Command.PlaceObstacle back
                && !back.obstacle().motion().equals(now.motion())
                && back.obstacle()
                        .motion()
                        .flatMap(before -> now.motion().map(way -> before.withSpeed(way.speed())))
                        .equals(now.motion());
        return undo instanceof Command.RemoveObstacle ? "edit.add" : speed ? "edit.waySpeed" : "edit.change";
    }

    private static String platformKey(Command.SetPlatform platform, List<Command> undo) {
        boolean speed = undo.get(0) instanceof Command.SetPlatform back && back.speed() != platform.speed();
        return speed ? "edit.speed" : "edit.platform";
    }

    private static String sensorEditName(Command redo, List<Command> undo) {
        if (redo instanceof Command.SwitchSensor change) {
            return Messages.get(change.on() ? "edit.switchOn" : "edit.switchOff", change.sensor());
        }
        if (redo instanceof Command.ConfigureSensor tune) {
            return Messages.get(sensorKey(tune.sensor(), undo), tune.sensor().id());
        }
        if (redo instanceof Command.InjectFault fault) {
            return Messages.get("edit.fault", fault.sensor());
        }
        return Messages.get(
                "edit.mend",
                redo instanceof Command.ClearFault one ? one.sensor() : ((Command.ClearFaults) redo).sensor());
    }

    private static String sensorKey(SensorSpec now, List<Command> undo) {
        SensorSpec before = undo.get(0) instanceof Command.ConfigureSensor back ? back.sensor() : now;
        Map<String, SensorSpec> single = new LinkedHashMap<>();
        single.put("edit.range", before.withRange(now.range()));
        single.put("edit.cone", before.withCone(now.cone()));
        single.put("edit.bearing", before.withBearing(now.bearing()));
        single.put("edit.seat", before.withMountPosition(now.mountPosition()));
        single.put("edit.noise", before.withNoise(now.noise()));
        return single.entrySet().stream()
                .filter(change -> change.getValue().equals(now))
                .map(Map.Entry::getKey)
                .findFirst()
                .orElse("edit.tune");
    }
}
