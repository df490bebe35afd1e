package faultline.scenario.xml;

import faultline.io.DecimalText;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** The attributes kind and value, which make a fault. */
final class FaultAttributes {

    private static final Map<String, FaultKind> KINDS = new LinkedHashMap<>();

    static {
        for (FaultKind kind : FaultKind.values()) {
            KINDS.put(kind.fileName(), kind);
        }
    }

    private FaultAttributes() {}

    /** The fault that the attributes describe, empty where the kind is not known. */
    static Optional<Fault> read(AttributeReader fields) {
        Optional<Fault> fault = fields.choice("kind", KINDS).map(kind -> kind.createFault(readValue(fields, kind)));
        fields.text("value");
        return fault;
    }

    private static double readValue(AttributeReader fields, FaultKind kind) {
        if (kind.takesValue()) {
            return fields.number("value", valueRange(kind), kind.defaultValue());
        }
        fields.text("value")
                .ifPresent(text -> fields.report(
                        "value", text, "none, because a fault of kind " + kind.fileName() + " takes no value"));
        return kind.defaultValue();
    }

    private static NumberRange valueRange(FaultKind kind) {
        return NumberRange.closed(
                DecimalText.format(kind.minValue()),
                DecimalText.format(kind.maxValue()),
                kind.unit().equals("m") ? "metres" : kind.unit());
    }
}
