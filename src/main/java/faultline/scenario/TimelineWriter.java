package faultline.scenario;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.util.List;

/** Writes the timeline. A fault whose mending comes next in the list is written as one element with {@code until}. */
final class TimelineWriter {

    private TimelineWriter() {}

    static void write(List<TimedCommand> commands, XmlWriter out) {
        out.beginElement("timeline");
        int next = 0;
        while (next < commands.size()) {
            TimedCommand timed = commands.get(next);
            boolean joined = next + 1 < commands.size() && isClearedBy(timed, commands.get(next + 1));
            if (joined) {
                Command.InjectFault inject = (Command.InjectFault) timed.command();
                beginFault("fault", timed.time(), inject.sensor(), inject.fault(), out)
                        .attribute("until", commands.get(next + 1).time())
                        .endElement();
            } else {
                writeCommand(timed, out);
            }
            next += joined ? 2 : 1;
        }
        out.endElement();
    }

    private static boolean isClearedBy(TimedCommand first, TimedCommand second) {
        return first.command() instanceof Command.InjectFault inject
                && second.time() > first.time()
                && second.command().equals(new Command.ClearFault(inject.sensor(), inject.fault()));
    }

    private static XmlWriter beginFault(String name, double at, String sensor, Fault fault, XmlWriter out) {
        beginCommand(name, at, out)
                .attribute("sensor", sensor)
                .attribute("kind", fault.kind().fileName());
        return fault.kind().takesValue() ? out.attribute("value", fault.value()) : out;
    }

    private static XmlWriter beginCommand(String name, double at, XmlWriter out) {
        return out.beginElement(name).attribute("at", at);
    }

    private static void writeCommand(TimedCommand timed, XmlWriter out) {
        double at = timed.time();
        Command command = timed.command();
        if (command instanceof Command.InjectFault inject) {
            beginFault("fault", at, inject.sensor(), inject.fault(), out).endElement();
        } else if (command instanceof Command.ClearFault clear) {
            beginFault("mend", at, clear.sensor(), clear.fault(), out).endElement();
        } else if (command instanceof Command.ClearFaults clear) {
            beginCommand("mend", at, out).attribute("sensor", clear.sensor()).endElement();
        } else if (command instanceof Command.SwitchSensor change) {
            beginCommand("switch", at, out)
                    .attribute("sensor", change.sensor())
                    .attribute("on", change.on())
                    .endElement();
        } else if (command instanceof Command.ConfigureSensor tune) {
            RobotWriter.writeSettings(
                            tune.sensor(),
                            beginCommand("tune", at, out)
                                    .attribute("sensor", tune.sensor().id()))
                    .endElement();
        } else {
            writeWorldCommand(command, at, out);
        }
    }

    private static void writeWorldCommand(Command command, double at, XmlWriter out) {
        if (command instanceof Command.MoveObstacle move) {
            WorldWriter.writePose(move.pose(), beginCommand("move", at, out).attribute("obstacle", move.obstacle()))
                    .endElement();
        } else if (command instanceof Command.PlaceObstacle put) {
            beginCommand("put", at, out);
            WorldWriter.writeObstacle(put.obstacle(), out);
            out.endElement();
        } else if (command instanceof Command.RemoveObstacle remove) {
            beginCommand("remove", at, out)
                    .attribute("obstacle", remove.obstacle())
                    .endElement();
        } else if (command instanceof Command.SetPlatform platform) {
            beginCommand("platform", at, out)
                    .attribute("length", platform.length())
                    .attribute("width", platform.width())
                    .attribute("speed", platform.speed())
                    .endElement();
        }
    }
}
