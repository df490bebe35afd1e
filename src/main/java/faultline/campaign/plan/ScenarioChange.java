package faultline.campaign.plan;

import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.SourceLocation;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A change of a scenario that a plan specifies. */
sealed interface ScenarioChange {

    /** Returns the location of the change in the plan. */
    SourceLocation location();

    /** Returns the values that the change sets. */
    Collection<AttributeValue> values();

    /** Changes the tree of a block of runs, counted from 0; the file of the plan is named in problems. */
    void apply(ScenarioTree tree, AttributeValue.UniformSource numbers, long block, String file)
            throws ScenarioException;

    /** Sets an attribute. */
    record SetAttribute(AttributePath path, AttributeValue value, SourceLocation location) implements ScenarioChange {

        @Override
        public Collection<AttributeValue> values() {
            return List.of(value);
        }

        @Override
        public void apply(ScenarioTree tree, AttributeValue.UniformSource numbers, long block, String file)
                throws ScenarioException {
            tree.set(path, value.text(numbers, block), file, location);
        }
    }

    /** Adds a {@code fault} with these attributes at the end of the timeline. */
    record AddFault(Map<String, AttributeValue> attributes, SourceLocation location) implements ScenarioChange {
        public AddFault {
            attributes = Collections.unmodifiableMap(new LinkedHashMap<>(attributes));
        }

        @Override
        public Collection<AttributeValue> values() {
            return attributes.values();
        }

        @Override
        public void apply(ScenarioTree tree, AttributeValue.UniformSource numbers, long block, String file) {
            Map<String, String> texts = new LinkedHashMap<>();
            attributes.forEach((name, value) -> texts.put(name, value.text(numbers, block)));
            tree.addFault(texts, location);
        }
    }
}
