package faultline.engine.trace;

import faultline.io.ShortestDecimal;
import faultline.robot.MotorFault;
import faultline.sensor.Fault;
import faultline.sensor.FaultDescriptor;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The text of a trace's cell that lists the active faults of a sensor or of the motors of a side, oldest first. */
final class FaultCell {

    private FaultCell() {}

    /** Returns the faults of a sensor as words, such as {@code stuck=0.4 noise=0.01}. */
    static String ofSensor(List<Fault> faults) {
        return join(faults.stream().map(fault -> word(fault.kind(), fault.value())));
    }

    /** Returns the faults of motors as words, such as {@code weak=0.7 dead}. */
    static String ofMotors(List<MotorFault> faults) {
        return join(faults.stream().map(fault -> word(fault.kind(), fault.value())));
    }

    private static String word(FaultDescriptor<?> kind, double value) {
        return kind.fileName() + (kind.takesValue() ? "=" + ShortestDecimal.text(value) : "");
    }

    private static String join(Stream<String> words) {
        return words.collect(Collectors.joining(" "));
    }
}
