package faultline.scenario;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.scenario.xml.XmlWriter;
import faultline.sensor.Fault;
import faultline.sensor.FaultDescriptor;
import faultline.world.Command;
import java.util.List;

/** Writes the timeline. A fault that the next command clears is written as one element with {@code until}. */
final class TimelineWriter {

    private final ControllerSpec.WallFollowing follower;
    private final XmlWriter out;
    private double time;
    /** The command that clears the fault that was written last; null if the last command added no fault. */
    private Command clearing;

    private TimelineWriter(ControllerSpec.WallFollowing follower, XmlWriter out) {
        this.follower = follower;
        this.out = out;
    }

    /** Writes the commands of a scenario, whose controller has the values of omitted attributes. */
    static void write(List<TimedCommand> commands, ControllerSpec controller, XmlWriter out) {
        TimelineWriter writer = new TimelineWriter(ControllerReader.defaultsFor(controller), out);
        out.beginElement("timeline");
        for (int i = 0; i < commands.size(); i++) {
            writer.time = commands.get(i).time();
            writer.clearing = null;
            XmlWriter element = writer.begin(commands.get(i).command());
            if (i + 1 < commands.size() && writer.isCleared(commands.get(i + 1))) {
                i++;
                element.attribute("until", commands.get(i).time());
            }
            element.endElement();
        }
        out.endElement();
    }

    private boolean isCleared(TimedCommand next) {
        return next.time() > time && next.command().equals(clearing);
    }

    private XmlWriter begin(String name) {
        return out.beginElement(name).attribute("at", time);
    }

    /** Writes a fault into the open element; its number and its length are ignored by kinds without them. */
    private XmlWriter writeFault(FaultDescriptor<?> kind, double value, double length) {
        out.attribute("kind", kind.fileName());
        if (kind.takesValue()) {
            out.attribute("value", value);
        }
        return kind.takesLength() ? out.attribute("length", length) : out;
    }

    private XmlWriter beginFault(String name, String sensor, Fault fault) {
        begin(name).attribute("sensor", sensor);
        return writeFault(fault.kind(), fault.value(), fault.length());
    }

    /** Begins the element of a command, with its attributes. */
    private XmlWriter begin(Command command) {
        return command.match(new Command.CommandCases<>(
                switchSensor -> begin("switch")
                        .attribute("sensor", switchSensor.sensor())
                        .attribute("on", switchSensor.on()),
                configureSensor -> RobotWriter.writeSettings(
                        configureSensor.sensor(),
                        begin("tune")
                                .attribute("sensor", configureSensor.sensor().id())),
                injectFault -> {
                    clearing = new Command.ClearFault(injectFault.sensor(), injectFault.fault());
                    return beginFault("fault", injectFault.sensor(), injectFault.fault());
                },
                clearFault -> beginFault("mend", clearFault.sensor(), clearFault.fault()),
                clearFaults -> begin("mend").attribute("sensor", clearFaults.sensor()),
                injectMotorFault -> {
                    clearing = new Command.ClearMotorFault(injectMotorFault.motor(), injectMotorFault.fault());
                    return beginMotorFault("fault", injectMotorFault.motor(), injectMotorFault.fault());
                },
                clearMotorFault -> beginMotorFault("mend", clearMotorFault.motor(), clearMotorFault.fault()),
                clearMotorFaults -> begin("mend")
                        .attribute("motor", clearMotorFaults.motor().fileName()),
                moveObstacle -> WorldWriter.writePose(
                        moveObstacle.pose(), begin("move").attribute("obstacle", moveObstacle.obstacle())),
                placeObstacle -> {
                    begin("put");
                    WorldWriter.writeObstacle(placeObstacle.obstacle(), out);
                    return out;
                },
                removeObstacle -> begin("remove").attribute("obstacle", removeObstacle.obstacle()),
                setPlatform -> begin("platform")
                        .attribute("length", setPlatform.length())
                        .attribute("width", setPlatform.width())
                        .attribute("speed", setPlatform.speed()),
                configureController -> new ControllerWriter(begin("controller"), follower, true)
                        .write(configureController.controller())));
    }

    private XmlWriter beginMotorFault(String name, MotorSide motor, MotorFault fault) {
        begin(name).attribute("motor", motor.fileName());
        return writeFault(fault.kind(), fault.value(), 0);
    }
}
