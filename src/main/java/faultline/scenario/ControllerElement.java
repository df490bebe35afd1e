package faultline.scenario;

import faultline.scenario.xml.XmlElement;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** A controller element of a file whose type has been replaced. */
public final class ControllerElement {

    private ControllerElement() {}

    /**
     * {@return an element without the attributes and children that a controller of its earlier type had and one of its
     * present type lacks}
     *
     * @param before the element with its earlier type, without mistakes
     * @param now the element with its present type
     * @param kept the names of the attributes and children that stay in any case
     */
    public static XmlElement withoutEarlierType(XmlElement before, XmlElement now, Set<String> kept) {
        if (ControllerReader.type(before).equals(ControllerReader.type(now))) {
            return now;
        }
        Map<String, String> attributes = new LinkedHashMap<>(now.attributes());
        ControllerReader.attributesOfOtherTypes(now).stream()
                .filter(name -> !kept.contains(name))
                .forEach(attributes::remove);
        List<String> allowed = ControllerReader.children(ControllerReader.type(now));
        List<XmlElement> children = now.children().stream()
                .filter(child -> allowed.contains(child.name()) || kept.contains(child.name()))
                .toList();
        return new XmlElement(now.name(), now.location(), attributes, children, now.text());
    }
}
