-- LearnBlock's robot for CoppeliaSim 4.6 and later.
--
-- Attach this to a dummy called LearnBlock, as a non-threaded simulation script. When the simulation
-- starts it builds a robot with two driven wheels where the dummy stands, looking along the dummy's x.
-- LearnBlock then calls the functions `describe`, `drive`, `sense` and `show` below.
--
-- CoppeliaSim counts metres, and radians counterclockwise; LearnBlock mm, and degrees clockwise seen
-- from above. This script speaks LearnBlock's units.

sim = require 'sim'

WHEEL_RADIUS = 0.04   -- m
TRACK = 0.14          -- m between the wheels
AXLE_X = -0.04        -- m, seen from the middle of the hull
HULL = {0.18, 0.11, 0.06}
HULL_Z = 0.07         -- m above the floor
CASTER_RADIUS = 0.02
RANGE = 1.0           -- m, of the distance sensors
SILENCE = 0.35        -- s without a word from the program after which the motors stop

-- Degrees to the right of straight ahead, for the sensors of each side, from left to right.
DIRECTIONS = {front = {-20, 0, 20}, left = {-60}, right = {60}, back = {180}}
GROUND = {left = 0.015, central = 0, right = -0.015}   -- m to the left of the middle
FACES = {
    joy = {0, 1, 0}, sadness = {0, 0, 1}, surprise = {1, 0.65, 0}, disgust = {0, 0.64, 0},
    anger = {1, 0, 0}, fear = {0.49, 0, 1}, neutral = {0, 0, 0}, none = {0, 0, 0},
}

-- Called by LearnBlock.

function describe()
    -- A program begins: what another one commanded, which may be gone, is over.
    drive(0, 0)
    return {
        devices = {
            'Base', 'Camera', 'Display', 'DistanceSensors', 'GroundSensors', 'Gyroscope',
            'LightSensor',
        },
        camera = camera,
    }
end

function drive(adv, rot)
    heard = sim.getSystemTime()
    local difference = math.rad(rot) * TRACK / 2
    leftSpeed = (adv / 1000 + difference) / WHEEL_RADIUS
    rightSpeed = (adv / 1000 - difference) / WHEEL_RADIUS
    roll()
end

function sense()
    heard = sim.getSystemTime()
    local x, y, heading = place()
    local seen = {}
    for side, sensors in pairs(distances) do
        seen[side] = {}
        for number, sensor in ipairs(sensors) do
            seen[side][number] = distance(sensor)
        end
    end
    local floor = {}
    for side, sensor in pairs(grounds) do
        floor[side] = 100 * intensity(sensor)
    end
    return {
        pose = {x, y, heading}, distances = seen, ground = floor,
        light = 1023 * intensity(camera),
    }
end

function show(emotion)
    heard = sim.getSystemTime()
    sim.setShapeColor(face, nil, sim.colorcomponent_emission, FACES[emotion] or FACES.none)
end

-- Called by CoppeliaSim.

function sysCall_init()
    heard = sim.getSystemTime()
    leftSpeed, rightSpeed = 0, 0
    buildHull()
    leftWheel = buildWheel('left', 1)
    rightWheel = buildWheel('right', -1)
    buildCaster()
    buildSensors()
end

function sysCall_actuation()
    roll()
end

function roll()
    -- A program that is heard again, after its computer was busy, drives on as it commanded.
    local alive = sim.getSystemTime() - heard <= SILENCE
    sim.setJointTargetVelocity(leftWheel, alive and leftSpeed or 0)
    sim.setJointTargetVelocity(rightWheel, alive and rightSpeed or 0)
end

-- What is sensed.

function place()
    -- The middle between the wheels: forward is a quarter of a turn to the right of left.
    local left = sim.getObjectPosition(leftWheel, sim.handle_world)
    local right = sim.getObjectPosition(rightWheel, sim.handle_world)
    local heading = math.deg(math.atan(left[1] - right[1], left[2] - right[2]))
    return 500 * (left[1] + right[1]), 500 * (left[2] + right[2]), heading
end

function distance(sensor)
    local found, metres = sim.readProximitySensor(sensor)
    return found == 1 and 1000 * metres or 2000
end

function intensity(sensor)
    -- The eleventh number of the packet is the average; before the first step there is none.
    local _, packet = sim.readVisionSensor(sensor)
    return packet and packet[11] or 0
end

-- What is built. Poses are x, y and z in m and a quaternion, x, y, z, w, seen from the hull.

function buildHull()
    hull = sim.createPrimitiveShape(sim.primitiveshape_cuboid, HULL, 0)
    sim.setObjectAlias(hull, 'LearnBlockRobot')
    local start = {0, 0, 0, 0, 0, 0, 1}
    local found, dummy = pcall(sim.getObject, '/LearnBlock')
    if found then
        start = sim.getObjectPose(dummy, sim.handle_world)
    end
    start[3] = HULL_Z
    sim.setObjectPose(hull, start, sim.handle_world)
    makeBody(hull, 500, 0.5)
    face = sim.createPrimitiveShape(sim.primitiveshape_cuboid, {0.005, 0.08, 0.04}, 0)
    sim.setObjectInt32Param(face, sim.shapeintparam_static, 1)
    sim.setObjectInt32Param(face, sim.shapeintparam_respondable, 0)
    attach(face, 'face', hull, {HULL[1] / 2 + 0.003, 0, 0, 0, 0, 0, 1})
end

function buildWheel(name, side)
    -- A joint turns about its z, which looks to the left: so a positive speed is forward.
    local half = math.sqrt(0.5)
    local kind = sim.joint_revolute or sim.joint_revolute_subtype
    local joint = sim.createJoint(kind, sim.jointmode_dynamic, 0, {0.04, 0.01})
    local pose = {AXLE_X, side * TRACK / 2, WHEEL_RADIUS - HULL_Z, -half, 0, 0, half}
    attach(joint, name .. 'Motor', hull, pose)
    sim.setObjectInt32Param(joint, sim.jointintparam_dynctrlmode, sim.jointdynctrl_velocity)
    sim.setJointTargetForce(joint, 2)
    sim.setJointTargetVelocity(joint, 0)
    local diameter = 2 * WHEEL_RADIUS
    local wheel = sim.createPrimitiveShape(sim.primitiveshape_cylinder, {diameter, diameter, 0.02}, 0)
    attach(wheel, name .. 'Wheel', joint, {0, 0, 0, 0, 0, 0, 1})
    makeBody(wheel, 800, 1)
    return joint
end

function buildCaster()
    -- A ball that slides; a force sensor holds it as nothing else holds two moving bodies.
    local holder = sim.createForceSensor(0, {0, 1, 1, 0, 0}, {0.01, 0, 0, 0, 0})
    local pose = {0.07, 0, CASTER_RADIUS - HULL_Z, 0, 0, 0, 1}
    attach(holder, 'casterHolder', hull, pose)
    local diameter = 2 * CASTER_RADIUS
    local ball = sim.createPrimitiveShape(
        sim.primitiveshape_spheroid, {diameter, diameter, diameter}, 0
    )
    attach(ball, 'caster', holder, {0, 0, 0, 0, 0, 0, 1})
    makeBody(ball, 500, 0)
end

function buildSensors()
    distances = {}
    for side, directions in pairs(DIRECTIONS) do
        distances[side] = {}
        for number, degrees in ipairs(directions) do
            distances[side][number] = buildDistance(side .. number, degrees)
        end
    end
    grounds = {}
    for side, y in pairs(GROUND) do
        grounds[side] = buildGround(side, y)
    end
    camera = sim.createVisionSensor(
        2, {320, 240, 0, 0}, {0.01, 10, math.rad(60), 0.02, 0, 0, 0, 0, 0, 0, 0}
    )
    attach(camera, 'camera', hull, {HULL[1] / 2 + 0.01, 0, 0.02, 0.5, 0.5, 0.5, 0.5})
end

function buildDistance(name, degrees)
    -- A ray along the sensor's z, from before the hull and its face; to the right is a negative turn.
    local kind = sim.proximitysensor_ray or sim.proximitysensor_ray_subtype
    local sensor = sim.createProximitySensor(
        kind, 16, 0, {3, 3, 2, 2, 1, 1, 0, 0},
        {0, RANGE, 0.01, 0.01, 0.01, 0.01, 0, 0, 0, 0, 0, 0, 0.01, 0, 0}
    )
    local turn = math.rad(-degrees)
    local s, c = math.sin(turn / 2) / 2, math.cos(turn / 2) / 2
    local edge = HULL[1] / 2 + 0.02
    local pose = {edge * math.cos(turn), 0.08 * math.sin(turn), 0, c - s, c + s, c + s, c - s}
    return attach(sensor, name, hull, pose)
end

function buildGround(name, y)
    -- Looks down on a square of 1 cm, its picture's top forward.
    local half = math.sqrt(0.5)
    local sensor = sim.createVisionSensor(
        0, {4, 4, 0, 0}, {0.001, 0.1, 0.01, 0.005, 0, 0, 0, 0, 0, 0, 0}
    )
    local pose = {HULL[1] / 2 + 0.01, y, 0.02 - HULL_Z, half, half, 0, 0}
    return attach(sensor, 'ground' .. name, hull, pose)
end

function makeBody(shape, density, friction)
    sim.setObjectInt32Param(shape, sim.shapeintparam_static, 0)
    sim.setObjectInt32Param(shape, sim.shapeintparam_respondable, 1)
    -- Its parts do not touch each other, and everything else.
    sim.setObjectInt32Param(shape, sim.shapeintparam_respondable_mask, 0xff00)
    sim.computeMassAndInertia(shape, density)
    if sim.setFloatProperty then
        sim.setFloatProperty(shape, 'bullet.friction', friction)
    else
        sim.setEngineFloatParam(sim.bullet_body_friction, shape, friction)
    end
end

function attach(object, name, parent, pose)
    sim.setObjectAlias(object, name)
    sim.setObjectParent(object, parent, true)
    sim.setObjectPose(object, pose, parent)
    return object
end
